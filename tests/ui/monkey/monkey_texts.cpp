#include "tests/ui/monkey/monkey_texts.h"

#include <algorithm>
#include <initializer_list>

namespace alidade::ui {

namespace {

QString anyOf(Chance& chance, std::initializer_list<const char*> texts) {
  return QString::fromUtf8(chance.of(texts));
}

QString angleText(Chance& chance) {
  return QStringLiteral("%1 %2 %3")
      .arg(chance.below(360))
      .arg(chance.below(60), 2, 10, QLatin1Char('0'))
      .arg(chance.below(60), 2, 10, QLatin1Char('0'));
}

/// A row of the session as copied, or an invented one.
QStringList rowOf(const Session& session, Chance& chance) {
  if (session.positions.empty() || chance.oneIn(4)) return {angleText(chance), angleText(chance)};
  const Position& position = chance.of(session.positions);
  if (position.readings.empty()) return {angleText(chance), QString()};
  const Reading& reading = chance.of(position.readings);
  return {QString::fromStdString(reading.horizontal), QString::fromStdString(reading.vertical)};
}

QByteArray csvFile(Chance& chance) {
  QString text = chance.oneIn(5) ? QStringLiteral("a,b\n") : QStringLiteral("axis,point,Hz,V\n");
  for (const int axis : {0, 180}) {
    text += QStringLiteral("%1,zero,332°32'54\",89°59'57\"\n").arg(axis);
    for (int row = chance.below(8); row > 0; --row)
      text += QStringLiteral("%1,%2,%3,%4\n")
                  .arg(axis)
                  .arg(row)
                  .arg(chance.oneIn(9) ? anyText(chance) : angleText(chance), angleText(chance));
  }
  return text.toUtf8();
}

QByteArray gsiFile(Chance& chance) {
  QByteArray text;
  for (int row = 1; row < 3 + chance.below(8); ++row)
    text += "11" + QByteArray::number(row).rightJustified(4, '0') + "+" +
            QByteArray::number(row).rightJustified(8, '0') + " 21.324+" +
            QByteArray::number(chance.below(35959599)).rightJustified(8, '0') + " 22.324+" +
            QByteArray::number(8800000 + chance.below(90000)).rightJustified(8, '0') + " \r\n";
  return text;
}

}  // namespace

QString slipped(QString text, Chance& chance) {
  if (text.isEmpty()) return QString(chance.of(QStringLiteral("0123456789")));
  const int at = chance.below(static_cast<int>(text.size()));
  switch (chance.below(5)) {
    case 0:
      return text.remove(at, 1);
    case 1:
      return text.insert(at, chance.of(QStringLiteral("0123456789 .-")));
    case 2:
      if (at + 1 < text.size()) std::swap(text[at], text[at + 1]);
      return text;
    default:
      text[at] = chance.of(QStringLiteral("0123456789"));
      return text;
  }
}

QString anyText(Chance& chance) {
  switch (chance.below(9)) {
    case 0:
      return angleText(chance);
    case 1:
      return QString::number(chance.between(-5, 4000));
    case 2:
      return QString::number(chance.below(100000) / 1000.0);
    case 3:
      return anyOf(chance, {"0", "1e-300", "1e300", "-0", "nan", "inf", "1e-9", "99999999999999999999"});
    case 4:
      return anyOf(chance, {"", " ", "°", "<b>x</b>", "“”", "\u202e12", "a\tb", "1,5", "½", "𝟙"});
    case 5:
      return QString::number(chance.below(4000000));
    case 6:
      return QString::number(chance.below(400000) / 1000.0) + QStringLiteral("gon");
    case 7:
      return anyOf(chance, {"1", "2", "0.5", "10", "0.1", "400", "2400", "95"});
    default:
      return QString(chance.between(1, 40), chance.of(QStringLiteral("0179x °'\"")));
  }
}

QString anyTable(const Session& session, Chance& chance) {
  const QChar between = chance.of(QStringLiteral("\t\t\t\t;, "));
  const int rows = chance.oneIn(40) ? chance.between(100, 400) : chance.between(1, 20);
  const int columns = chance.oneIn(4) ? chance.between(1, 9) : 2;
  QStringList lines;
  for (int i = 0; i < rows; ++i) {
    QStringList cells = rowOf(session, chance);
    while (cells.size() < columns) cells.append(chance.oneIn(2) ? anyText(chance) : angleText(chance));
    while (cells.size() > columns) cells.removeLast();
    if (chance.oneIn(8)) cells.last() = slipped(cells.last(), chance);
    lines.append(cells.join(between));
  }
  return lines.join(chance.oneIn(3) ? QStringLiteral("\r\n") : QStringLiteral("\n"));
}

QByteArray anyReadingsFile(Chance& chance) {
  QByteArray bytes = chance.oneIn(2) ? csvFile(chance) : gsiFile(chance);
  if (chance.oneIn(6)) bytes.truncate(chance.below(static_cast<int>(bytes.size()) + 1));
  if (chance.oneIn(8))
    bytes.insert(chance.below(static_cast<int>(bytes.size()) + 1), char(chance.below(256)));
  return bytes;
}

}  // namespace alidade::ui
