#pragma once

#include <QList>
#include <Qt>
#include <initializer_list>

class QMargins;
class QSplitter;
class QWidget;

namespace alidade::ui {

/// `parts` beside or above each other, each as large as of `sizes` at first. `name` is what its state is
/// remembered by.
QSplitter* split(Qt::Orientation orientation, const char* name, std::initializer_list<QWidget*> parts,
                 const QList<int>& sizes);

/// A splitter's own margins do not count in its minimum size; a layout's do.
QWidget* padded(QWidget* content, const QMargins& margins);

/// All of it where there is room, else a part to be scrolled.
QWidget* scrolled(QWidget* content);

/// The lower one takes all the room that is left.
QWidget* stacked(QWidget* upper, QWidget* lower);

}  // namespace alidade::ui
