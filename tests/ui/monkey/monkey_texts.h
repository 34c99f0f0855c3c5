#pragma once

#include <QString>

#include "core/session/session.h"
#include "tests/ui/monkey/chance.h"

namespace alidade::ui {

/// Texts a monkey types, pastes and writes to files.

/// `text` with one slip of a finger.
QString slipped(QString text, Chance& chance);
/// A value for a field: a number or an angle, sensible, huge, tiny, or no number.
QString anyText(Chance& chance);
/// A block for the table of readings: rows of the session or invented ones, with too many or too few columns,
/// rarely hundreds of them.
QString anyTable(const Session& session, Chance& chance);
/// A file of readings, CSV or GSI, valid or truncated.
QByteArray anyReadingsFile(Chance& chance);

}  // namespace alidade::ui
