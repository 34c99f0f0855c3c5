#pragma once

#include <QString>

namespace alidade::ui {

/// While it exists, the thread uses another language than the program, for a report in its reader's language.
/// Scopes may be nested.
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
