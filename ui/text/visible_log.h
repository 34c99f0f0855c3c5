#pragma once

namespace alidade::ui {

/// Makes log output of Qt and this program, including file names, go to stderr with invisible characters
/// escaped.
void keepLogVisible();

}  // namespace alidade::ui
