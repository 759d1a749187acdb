#pragma once
// SPDX-License-Identifier: Apache-2.0
// PrintDialog: paperwork or a cue book as a job in the background: what of it, its progress, and a preview of
// what was made. The window goes on meanwhile. Window thread.

#include "ui/actions/actions.h"
#include "ui/model/app_model.h"
#include "ui/model/show_document.h"
#include "ui/window/private/print_preview.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>

namespace ghost::ui {

// "paperwork", "cue-book": they open it.
void add_print_actions(Actions& actions, AppModel& app, ShowDocument& document, QWidget& window);

class PrintDialog : public QDialog {
    Q_OBJECT
public:
    enum class What { paper, book };
    // Its Ctrl+S saves the show, as everywhere: a job reads the show file.
    PrintDialog(What what, AppModel& app, ShowDocument& document, Actions& actions, QWidget* parent);

    QString options() const; // of the command, as a script line has them

private:
    void add_paper_choices(QFormLayout& form);
    void add_book_choices(QFormLayout& form);
    void offer_scales();
    void offer_moments();
    bool takes_marks() const;
    QWidget* make_preview();
    void name_show();
    void make();
    void forget_result();
    void hear_of_save();
    void follow();
    void show_result();
    void show_table();
    void show_pictures();
    void show_empty();

    What what_;
    AppModel& app_;
    ShowDocument& document_;
    bool was_changed_; // the show was not saved
    Actions& actions_;
    int job_ = 0; // that runs, or was the last; 0: none
    bool is_shown_ = false;
    QString made_;     // the folder that the job makes
    QString proposed_; // beside the show
    QLineEdit* folder_;
    QComboBox *page_, *language_, *units_, *scale_ = nullptr, *sheet_ = nullptr, *moment_ = nullptr;
    QComboBox *entries_ = nullptr, *camera_ = nullptr, *size_ = nullptr, *layout_ = nullptr;
    QLineEdit *against_ = nullptr, *marks_ = nullptr, *section_ = nullptr, *date_ = nullptr;
    QCheckBox *pdf_, *plan_ = nullptr, *focus_ = nullptr;
    QLabel* said_;
    QProgressBar* bar_;
    QPushButton *make_, *cancel_, *open_, *open_folder_;
    QComboBox* tables_ = nullptr;
    QTableWidget* table_ = nullptr;
    QListWidget* pictures_ = nullptr;
    QPlainTextEdit *unknown_, *remarks_;
    QLabel* empty_; // in the place of what is seen of it
    std::vector<PrintedTable> printed_; // in the order of tables_
};

} // namespace ghost::ui
