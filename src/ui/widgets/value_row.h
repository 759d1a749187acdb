#pragma once
// SPDX-License-Identifier: Apache-2.0
// ValueRow: one number under the hand: its name, a slider, a field, and a button that gives it back to the
// show. It shows what is there until it is moved. Window thread.

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QString>
#include <QToolButton>
#include <QValidator>
#include <QWidget>

#include <functional>
#include <optional>
#include <utility>

namespace ghost::ui {

struct ValueRange {
    double low = 0;
    double high = 1;
    int decimals = 2;
    QString unit;          // " m"
    bool by_ratio = false; // the slider's steps are ratios: for what spans decades; low above 0
};

// Says "mixed", or another word, instead of its number where it is told to.
class MixedSpinBox : public QDoubleSpinBox {
    Q_OBJECT
public:
    explicit MixedSpinBox(QWidget* parent);
    bool is_mixed() const { return !word_.isEmpty(); }
    void set_mixed(bool mixed) { set_word(mixed ? mixed_word() : QString()); }
    void set_word(const QString& word); // empty: its number
    static QString mixed_word();
    bool is_being_typed() const; // and not entered
    // The number that was there already was typed: a person wants it, whatever the desk does later; or that
    // of the first in the place of the word.
    std::function<void(double)> on_typed_over;
    // A step of what is mixed has no number to begin from.
    std::function<void(double by)> on_mixed_step;
    void stepBy(int steps) override;
    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& place) const override;

protected:
    StepEnabled stepEnabled() const override;

private:
    QString word_; // empty: its number
    QString last_word_;
    bool has(const QString& text) const { return !last_word_.isEmpty() && text.contains(last_word_); }
    QString unit_;
    bool is_typed_over_ = false;   // and not finished
    std::optional<double> before_; // when typing began; nothing: a word stood there
};

// What a slider does that stands for several values: a hand that takes it begins, and goes on until it lets
// go. Keys and clicks beside the handle are a beginning each.
class MixedDrag {
public:
    void show(bool mixed, double place, bool is_held) {
        if (is_held) return; // what it was when it was taken
        mixed_ = mixed;
        from_ = place;
        goes_on_ = false;
    }
    bool is_mixed() const { return mixed_; }
    double from() const { return from_; }
    // True: the first move of it.
    bool begins(bool is_held) { return !std::exchange(goes_on_, is_held); }
    void end() { goes_on_ = false; }

private:
    bool mixed_ = false, goes_on_ = false;
    double from_ = 0;
};

// The places of a row's label, slider, field and button: one line, or two where the slider would be shorter
// in it than a hand needs.
class RowLines {
public:
    RowLines(QWidget& row, QWidget& label, QWidget& slider, QWidget& field, QWidget& button);
    void fit(); // when the row gets another width
    bool has_two() const { return has_two_; }

private:
    QWidget &row_, &label_, &slider_, &field_, &button_;
    QGridLayout* grid_;
    bool has_two_ = false;
};

class ValueRow : public QWidget {
    Q_OBJECT
public:
    // Of the names of rows, so that all of a panel begin at one place.
    static int label_width(const QWidget& widget);
    // Rows find room in the narrowest column, beside a scroll bar; a slider has at least kHandy_px, or a
    // line.
    static constexpr int kLeastSlider_px = 22, kHandy_px = 80, kBetween_px = 3;
    ValueRow(const QString& name, const ValueRange& range, QWidget* parent);

    // by_hand: it is set by a person; else it is only shown. mixed: others have other values; the word stands
    // there until one is given to all. Does not call back.
    void show_value(double value, bool by_hand, bool mixed = false);
    // It has no value now, a dash stands there; what is typed or dragged is one. Does not call back.
    void show_none();
    // Does not call back.
    void set_reach(double low, double high);
    std::function<void(double)> on_change; // a person moved it
    // Mixed, each of its own value by so much; for who shows what is mixed.
    std::function<void(double by)> on_mixed_step;
    // The slider where values are mixed: each from what it had when the hand took the slider (from) to `to`.
    // What was at an end comes back with it. begins: that is now.
    std::function<void(double from, double to, bool begins)> on_mixed_drag;
    std::function<void()> on_refresh; // show_value is wanted: the slider was let go
    std::function<void()> on_release; // none: there is nothing to give it back to

protected:
    void resizeEvent(QResizeEvent*) override { lines_.fit(); }

private:
    int to_slider(double value) const;
    double from_slider(int at) const;

    ValueRange range_;
    QLabel* label_;
    QSlider* slider_;
    MixedSpinBox* field_;
    QToolButton* release_;
    RowLines lines_;
    bool follows_ = false; // it is being set, not moved
    MixedDrag drag_;
};

} // namespace ghost::ui
