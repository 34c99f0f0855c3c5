#pragma once

#include <QString>
#include <vector>

namespace alidade::ui {

/// A language of the program.
struct LanguageInfo {
  QString id;    ///< "en", "zh_CN"
  QString name;  ///< in the language itself: "简体中文"
};

/// All languages, English first, since the sources are written in English.
const std::vector<LanguageInfo>& allLanguages();

/// `id` if supported; else the desktop's language if supported; else English.
QString languageOr(const QString& id);

/// The language chosen on this machine, effective from the next start; empty: that of the desktop.
QString rememberedLanguage();
void rememberLanguage(const QString& id);

/// Sets the language of all texts of the program and Qt, except within a `LanguageScope`: for `tr` and
/// `Phrase::of`, on any thread. Call once, before the first window. `id` as in `languageOr`.
void speak(const QString& id);

/// The current language of this thread.
QString shownLanguage();

/// While a scope exists, its thread uses another language than the program, for a report in the language of
/// its reader. Scopes may be nested.
class LanguageScope {
 public:
  /// `id`: that of a `LanguageInfo`; with any other text, even an empty one, the thread keeps its language.
  explicit LanguageScope(const QString& id);
  ~LanguageScope();
  LanguageScope(const LanguageScope&) = delete;
  LanguageScope& operator=(const LanguageScope&) = delete;

 private:
  const void* m_before;
};

}  // namespace alidade::ui
