#pragma once

#include <functional>

#include "ui/charts/plotting/row_choice.h"

class QAction;
class QMenu;

namespace alidade::ui {

/// Adds a checkable entry, alone or as one of several.
QAction* addChoice(QMenu& menu, const QString& text, bool isChosen, const std::function<void()>& choose);

/// Adds menus for the rounds and for the faces in `kinds` if there are several. `choose` receives the choice.
void addRowChoices(QMenu& menu, const RowKinds& kinds, const RowChoice& choice,
                   const std::function<void(const RowChoice&)>& choose);

}  // namespace alidade::ui
