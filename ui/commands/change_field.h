#pragma once

#include <QUndoCommand>
#include <string>

#include "core/base/place.h"

namespace alidade::ui {

class SessionDocument;

/// Sets one field of the session; see `fieldNamed` for those there are.
class ChangeField : public QUndoCommand {
 public:
  ChangeField(SessionDocument& document, const Place& place, std::string text);

  void undo() override;
  void redo() override;

 private:
  SessionDocument& m_document;
  Place m_place;
  std::string m_before, m_after;
};

/// Does nothing where the field has this text already.
void changeField(SessionDocument& document, const Place& place, const std::string& text);

}  // namespace alidade::ui
