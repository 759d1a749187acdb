// SPDX-License-Identifier: Apache-2.0
#include "ui/language/language.h"

#include "ui/language/private/catalogues.h"

#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#include <memory>

namespace ghost::ui {
namespace {

std::unique_ptr<QTranslator> load(const QString& code) {
    auto translator = std::make_unique<QTranslator>();
    for (const Catalogue& one : catalogues())
        if (code == QLatin1String(one.code.data(), static_cast<qsizetype>(one.code.size())))
            if (translator->load(one.bytes.data(), static_cast<int>(one.bytes.size()))) return translator;
    return translator; // empty
}

// Of plurals alone: "%n head(s)" is "1 head" or "2 heads".
const QTranslator& english() {
    static const std::unique_ptr<QTranslator> kEnglish = load("en");
    return *kEnglish;
}

struct Chosen {
    QString code = "en";
    std::unique_ptr<QTranslator> texts, of_qt;
};

Chosen& chosen() {
    static Chosen one;
    return one;
}

} // namespace

QString language_of_system() {
    for (const QString& wanted : QLocale::system().uiLanguages())
        for (const LanguageChoice& one : kLanguages)
            if (wanted.section('-', 0, 0) == one.code) return one.code;
    return "en";
}

void set_language(const QString& code) {
    Chosen& now = chosen();
    now = {code, load(code), std::make_unique<QTranslator>()};
    // Of its package where that is installed; what it lacks is in ours, under Qt's own contexts.
    if (now.of_qt->load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(now.of_qt.get());
    QCoreApplication::installTranslator(now.texts.get());
}

const QString& language() {
    return chosen().code;
}

QString translated(const char* context, const char* source, const char* note, int count) {
    QString text;
    if (chosen().texts) text = chosen().texts->translate(context, source, note, count);
    if (text.isEmpty() && count >= 0) text = english().translate(context, source, note, count);
    if (text.isEmpty()) text = QString::fromUtf8(source);
    if (count >= 0) text.replace("%n", QString::number(count));
    return text;
}

} // namespace ghost::ui
