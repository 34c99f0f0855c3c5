#pragma once

#include <QList>
#include <Qt>
#include <initializer_list>

class QMargins;
class QSplitter;
class QWidget;

namespace alidade::ui {

/// Puts `parts` side by side or above each other, with `sizes` as initial sizes. The state of the splitter is
/// remembered under `name` once one of its handles was moved.
QSplitter* split(Qt::Orientation orientation, const char* name, std::initializer_list<QWidget*> parts,
                 const QList<int>& sizes);

/// True once a person moved a handle of the splitter, here or in the window whose layout was restored.
bool isSetByHand(const QSplitter& splitter);
void markSetByHand(QSplitter& splitter);

/// Gives the margins to a layout around `content`: a splitter's minimum size ignores other margins.
QWidget* padded(QWidget* content, const QMargins& margins);

/// Shows the whole content if there is room, else scrolls it.
QWidget* scrolled(QWidget* content);

/// Puts one widget above the other; the lower one takes all remaining room.
QWidget* stacked(QWidget* upper, QWidget* lower);

}  // namespace alidade::ui
