#pragma once
// SPDX-License-Identifier: Apache-2.0
// The language of the window: which there are, and its texts in that one. Catalogues are made of
// assets/translations/*.ts and are part of the program; what they lack is said in English, in which texts
// stand in the sources. What scripts, sockets, files, logs and the command line read is always English.
// Window thread.

#include "ui/language/language_choice.h"

#include <QCoreApplication>
#include <QString>

#include <string>

namespace ghost::ui {

// Of the desktop's, the first that there is.
QString language_of_system();

// For all texts from here on, those that Qt itself makes too; those that are on the screen stay. Another code
// than those of kLanguages: English.
void set_language(const QString& code);
const QString& language();

// A text of the window; lupdate collects them by this name. note: for whoever translates. count: replaces %n,
// and chooses between one and many.
QString translated(const char* context, const char* english, const char* note = nullptr,
                   long long count = -1);

// A sentence of a room without Qt, as sentence_list.cpp knows them; another one as it is.
QString said(const std::string& english);
QString said(const char* english);
QString said(const QString& english);

} // namespace ghost::ui
