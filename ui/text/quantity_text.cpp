#include "ui/text/quantity_text.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle_text.h"
#include "core/base/number_text.h"

namespace alidade::ui {
namespace {

constexpr int mostDecimals = 9;

QString withRealMinus(const std::string& ascii) {
  QString text = QString::fromStdString(ascii);
  return text.replace(u'-', QChar(0x2212));
}

bool isZero(const QString& text) {
  return std::all_of(text.begin(), text.end(), [](QChar c) { return c == u'0' || c == u'.'; });
}

}  // namespace

QString notStated() {
  return QString(QChar(0x2014));
}

QString orNotStated(const QString& text) {
  return text.trimmed().isEmpty() ? notStated() : text;
}

QString numberText(double value, int decimals) {
  return std::isfinite(value) ? withRealMinus(fixedText(value, decimals)) : notStated();
}

QString signedNumberText(double value, int decimals) {
  const QString text = numberText(value, decimals);
  const bool plus = std::isfinite(value) && value > 0 && !isZero(text);
  return plus ? u'+' + text : text;
}

QString plainNumberText(double value) {
  return std::isfinite(value) ? withRealMinus(shortestText(value)) : notStated();
}

QString lengthText(double millimetres, int decimals) {
  return numberText(millimetres, decimals) + QStringLiteral(" mm");
}

QString arcsecText(double arcseconds, int decimals) {
  return numberText(arcseconds, decimals) + QChar(0x2033);
}

QString dmsText(Angle angle, int decimals) {
  return std::isfinite(angle.radians()) ? QString::fromStdString(formatDms(angle, decimals)) : notStated();
}

int decimalsFor(double uncertainty, int fallback) {
  if (!std::isfinite(uncertainty) || uncertainty <= 0) return fallback;
  // 0.0996 rounds up to 0.10: judge the size after rounding to two digits.
  const double rounded = uncertainty / 0.995;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(rounded))), 0, mostDecimals);
}

QString valueWithUncertainty(double value, double uncertainty, const QString& unit) {
  const int decimals = decimalsFor(uncertainty);
  const QString tail = unit.isEmpty() ? QString() : u' ' + unit;
  return numberText(value, decimals) + QStringLiteral(" ± ") + numberText(uncertainty, decimals) + tail;
}

QString exaggerationText(double factor) {
  return QStringLiteral("× ") + plainNumberText(factor);
}

}  // namespace alidade::ui
