#pragma once

#include "ui/language/languages.h"

namespace alidade::ui {

/// Sets the language of the whole program; restores English on destruction.
class Speaking {
 public:
  explicit Speaking(const QString& id) { speak(id); }
  ~Speaking() { speak(QStringLiteral("en")); }
  Speaking(const Speaking&) = delete;
  Speaking& operator=(const Speaking&) = delete;
};

}  // namespace alidade::ui
