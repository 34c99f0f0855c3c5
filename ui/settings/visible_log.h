#pragma once

namespace alidade::ui {

/// From here on what Qt and this program log, names of files among it, goes to stderr as visible lines.
void keepLogVisible();

}  // namespace alidade::ui
