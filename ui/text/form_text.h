#pragma once

#include <QString>

#include "core/diagnosis/result/form.h"

namespace alidade::ui {

/// What looks like a form here, and where the model holds without it; may be empty.
QString aboutForm(const FoundForm& form);

}  // namespace alidade::ui
