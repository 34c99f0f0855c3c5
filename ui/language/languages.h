#pragma once

#include <QString>
#include <vector>

namespace alidade::ui {

/// A language that the program speaks.
struct LanguageInfo {
  QString id;    ///< "en", "zh_CN"
  QString name;  ///< in itself: "简体中文"
};

/// English, in which the sources are written, first.
const std::vector<LanguageInfo>& allLanguages();

/// That of an id, or of the desktop's locale where there is none such; English if the desktop speaks none of
/// ours.
QString languageOr(const QString& id);

/// What is chosen on this machine, from the next start on; empty: as the desktop.
QString rememberedLanguage();
void rememberLanguage(const QString& id);

/// From here on texts of the program and of Qt are in this language, except where a `LanguageScope` has
/// another: `tr` and `Phrase::of` alike, on any thread. Call once, before the first window. `id` as of
/// `languageOr`.
void speak(const QString& id);

/// What this thread speaks now.
QString spokenLanguage();

}  // namespace alidade::ui
