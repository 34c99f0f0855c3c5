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

/// The language of an id, or of the desktop's locale if the id is unknown; English if none is supported.
QString languageOr(const QString& id);

/// The choice on this machine, effective from the next start; empty: the desktop's.
QString rememberedLanguage();
void rememberLanguage(const QString& id);

/// Sets the language of all texts of the program and Qt, except within a `LanguageScope`: for `tr` and
/// `Phrase::of`, on any thread. Call once, before the first window. `id` as in `languageOr`.
void speak(const QString& id);

/// The current language of this thread.
QString shownLanguage();

/// While such an object exists, its thread uses another language than the program, for a report in its
/// reader's language. Scopes may be nested.
class LanguageScope {
 public:
  /// `id` of a `LanguageInfo`; for any other, even empty, the thread keeps its language.
  explicit LanguageScope(const QString& id);
  ~LanguageScope();
  LanguageScope(const LanguageScope&) = delete;
  LanguageScope& operator=(const LanguageScope&) = delete;

 private:
  const void* m_before;
};

}  // namespace alidade::ui
