#pragma once

#include "ui/language/languages.h"

namespace alidade::ui {

/// While it lives, the whole program speaks a language; then English again.
class Speaking {
 public:
  explicit Speaking(const QString& id) { speak(id); }
  ~Speaking() { speak(QStringLiteral("en")); }
  Speaking(const Speaking&) = delete;
  Speaking& operator=(const Speaking&) = delete;
};

}  // namespace alidade::ui
