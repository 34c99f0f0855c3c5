#pragma once

#include <QUndoCommand>
#include <cstddef>

#include "core/session/session.h"

namespace alidade::ui {

class SessionDocument;

/// Adds a position of the axis without readings. The one at 0° goes first, since it is taken first; the one
/// at 180° goes last.
class AddPosition : public QUndoCommand {
 public:
  /// `axisDeg`: 0 or 180.
  AddPosition(SessionDocument& document, int axisDeg);

  void undo() override;
  void redo() override;

 private:
  SessionDocument& m_document;
  std::size_t m_index;
  Position m_position;
};

/// Has the session a position at `axisDeg`, 0 or 180? One whose axis cannot be understood is at neither.
bool hasPosition(const Session& session, int axisDeg);

/// Does nothing where the session has this position already.
void addPosition(SessionDocument& document, int axisDeg);

}  // namespace alidade::ui
