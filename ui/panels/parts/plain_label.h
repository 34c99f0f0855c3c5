#pragma once

class QLabel;
class QString;

namespace alidade::ui {

/// A wrapping label that shows its text without interpreting markup.
QLabel* createPlainLabel(const QString& text);

}  // namespace alidade::ui
