#include "ui/import/import_memory.h"

#include <QCryptographicHash>
#include <QSettings>
#include <QStringList>
#include <algorithm>

#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

constexpr qsizetype mostLayouts = 50;

/// The settings key of a layout: a hash, since a signature contains column names of any text and length.
QString keyOf(const Recognised& recognised) {
  const QByteArray hash =
      QCryptographicHash::hash(QByteArray::fromStdString(recognised.signature()), QCryptographicHash::Sha256);
  return QStringLiteral("import/layouts/") + QString::fromLatin1(hash.toHex());
}

void dropOldest(QSettings& settings, const QString& newest) {
  const QString order = QStringLiteral("import/order");
  QStringList keys = settings.value(order).toStringList();
  keys.removeAll(newest);
  keys.append(newest);
  while (keys.size() > mostLayouts) settings.remove(keys.takeFirst());
  settings.setValue(order, keys);
}

}  // namespace

std::optional<TableLayout> ImportMemory::layoutOf(const Recognised& recognised) {
  const QStringList kept = QSettings().value(keyOf(recognised)).toStringList();
  constexpr qsizetype before = 3;
  if (kept.size() != before + static_cast<qsizetype>(recognised.table.columns.size())) return std::nullopt;
  const int unit = kept[0].toInt(), sign = kept[1].toInt();
  const bool isSound = unit >= 0 && unit <= static_cast<int>(AngleUnit::Dms) && sign >= 0 &&
                       sign <= static_cast<int>(DecimalSign::Comma);
  if (!isSound) return std::nullopt;
  TableLayout layout = recognised.table;
  if (layout.unit == AngleUnit::Unstated) layout.unit = static_cast<AngleUnit>(unit);
  if (layout.decimalSign == DecimalSign::Either) layout.decimalSign = static_cast<DecimalSign>(sign);
  const int headRows = static_cast<int>(layout.headRows) + kept[2].toInt();
  layout.headRows = static_cast<std::size_t>(std::max(headRows, 0));
  layout.columns.clear();
  for (const QString& column : kept.mid(before)) {
    const std::string key = column.toStdString();
    if (!key.empty() && !tableColumn(key)) return std::nullopt;
    layout.columns.push_back(key);
  }
  return layout;
}

void ImportMemory::keep(const Recognised& recognised, const TableLayout& layout) {
  QStringList kept = {
      QString::number(static_cast<int>(layout.unit)), QString::number(static_cast<int>(layout.decimalSign)),
      QString::number(static_cast<int>(layout.headRows) - static_cast<int>(recognised.table.headRows))};
  for (const std::string& column : layout.columns) kept.append(qText(column));
  QSettings settings;
  dropOldest(settings, keyOf(recognised));
  settings.setValue(keyOf(recognised), kept);
}

}  // namespace alidade::ui
