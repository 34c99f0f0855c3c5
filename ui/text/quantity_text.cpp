#include "ui/text/quantity_text.h"

#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace alidade::ui {
namespace {

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
  return QString::fromStdString(displayText(value, decimals));
}

QString signedNumberText(double value, int decimals) {
  const QString text = numberText(value, decimals);
  const bool plus = std::isfinite(value) && value > 0 && !isZero(text);
  return plus ? u'+' + text : text;
}

QString plainNumberText(double value) {
  if (!std::isfinite(value)) return notStated();
  // Ten digits hide the rounding of a conversion from degrees to radians and back.
  const QString rounded = QString::number(value, 'g', 10);
  return QString::fromStdString(displayShortest(rounded.toDouble()));
}

QString lengthText(double millimetres, int decimals) {
  return numberText(millimetres, decimals) + QStringLiteral(" mm");
}

QString arcsecText(double arcseconds, int decimals) {
  return numberText(arcseconds, decimals) + QChar(0x2033);
}

QString angleText(Angle angle, CircleUnit unit, int decimals) {
  return std::isfinite(angle.radians()) ? QString::fromStdString(formatAngle(angle, unit, decimals))
                                        : notStated();
}

QString unbroken(QString text) {
  static const QRegularExpression gap(QStringLiteral("(?<=[±<>≤≥]) (?=\\d)|(?<=\\d) (?=mm|%|°)"));
  return text.replace(gap, QString(QChar::Nbsp));
}

QString exaggerationText(double factor) {
  return QStringLiteral("× ") + plainNumberText(factor);
}

}  // namespace alidade::ui
