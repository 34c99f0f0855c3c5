#pragma once

class QLabel;
class QString;

namespace alidade::ui {

/// Wraps, and shows what is typed or read as it is: no markup.
QLabel* createPlainLabel(const QString& text);

}  // namespace alidade::ui
