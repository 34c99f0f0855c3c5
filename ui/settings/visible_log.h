#pragma once

namespace alidade::ui {

/// From here on, log output of Qt and this program, including file names, goes to stderr with invisible
/// characters escaped.
void keepLogVisible();

}  // namespace alidade::ui
