#include "ui/language/language_scope.h"

#include "ui/language/interpreter.h"

namespace alidade::ui {

LanguageScope::LanguageScope(const QString& id) : m_before(Interpreter::ownTongue()) {
  if (const Tongue* tongue = tongueOf(id)) Interpreter::ownTongue() = tongue;
}

LanguageScope::~LanguageScope() {
  Interpreter::ownTongue() = static_cast<const Tongue*>(m_before);
}

}  // namespace alidade::ui
