#pragma once

#include <QString>

#include "core/base/angle.h"
#include "core/base/angle_text.h"
#include "core/base/number_text.h"

namespace alidade::ui {

// Numbers for screen and paper: a decimal point, a real minus sign (−), a blank before letters of a unit and
// none before ° ′ ″. An unknown or non-finite number is an em dash.

/// "—": for an unknown number or an empty field of a form.
QString notStated();

/// `text`, or "—" if it is empty.
QString orNotStated(const QString& text);

/// The number with fixed decimals (0…9): "−0.835", never "−0.000".
QString numberText(double value, int decimals);

/// Like `numberText`, with an explicit plus sign: "+1.3", "−1.3", "0.0".
QString signedNumberText(double value, int decimals);

/// The shortest text of the number rounded to ten digits: "2405", "0.95", and "5" for 4.999 999 999 99.
QString plainNumberText(double value);

/// "401.9543 mm".
QString lengthText(double millimetres, int decimals = 4);

/// "9.4″".
QString arcsecText(double arcseconds, int decimals = 1);

/// The angle in `unit` (`formatAngle`), not wrapped: "341°52′24″". `decimals`: those of the seconds.
QString angleText(Angle angle, CircleUnit unit = CircleUnit::Dms, int decimals = 0);

/// Keeps each figure with its sign and unit when the line wraps. The text has as many characters as before.
QString unbroken(QString text);

/// "× 500".
QString exaggerationText(double factor);

}  // namespace alidade::ui
