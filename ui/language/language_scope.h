#pragma once

#include <QString>

namespace alidade::ui {

/// While it lives, the thread speaks another language than the program: for a report in the language of its
/// reader. Scopes may lie within one another.
class LanguageScope {
 public:
  /// `id` of a `LanguageInfo`; of anything else, as an empty one, the thread goes on as before.
  explicit LanguageScope(const QString& id);
  ~LanguageScope();
  LanguageScope(const LanguageScope&) = delete;
  LanguageScope& operator=(const LanguageScope&) = delete;

 private:
  const void* m_before;
};

}  // namespace alidade::ui
