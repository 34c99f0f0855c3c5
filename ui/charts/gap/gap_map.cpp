#include "ui/charts/gap/gap_map.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/exchange/csv_text.h"
#include "core/wording/gap_shares.h"
#include "ui/charts/plotting/plot_style.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

QString percentText(double share) {
  return numberText(100 * share, 0) + QStringLiteral(" %");
}

/// The number at the start of a name, which sorts "90…120°" after "60…90°"; 0 for words.
double numberIn(const QString& name) {
  QString digits;
  for (const QChar character : name) {
    if (!character.isDigit() && character != u'-' && character != QChar(0x2212)) break;
    digits += character == QChar(0x2212) ? u'-' : character;
  }
  return digits.toDouble();
}

}  // namespace

GapMap::GapMap(QWidget* parent) : BarRows(tr("Where the gap lies"), QStringLiteral("gap-where"), parent) {}

std::string GapMap::numbers() const {
  CsvText csv{"by", "part", "share"};
  for (const Bar& bar : m_bars)
    for (const Part& part : bar.parts)
      csv.typed(bar.by.toStdString()).typed(part.name.toStdString()).number(part.share).endRow();
  return csv.text();
}

void GapMap::setShares(const std::vector<GapShare>& shares) {
  m_bars.clear();
  for (const GapShare& share : shares) {
    const QString by = qText(divisionName(share));
    if (m_bars.empty() || m_bars.back().by != by) m_bars.push_back({by, {}});
    m_bars.back().parts.push_back({qText(partName(share)), share.share});
  }
  std::erase_if(m_bars, [](const Bar& bar) { return bar.parts.size() < 2; });
  QStringList accessible;
  for (Bar& bar : m_bars) {
    std::stable_sort(bar.parts.begin(), bar.parts.end(),
                     [](const Part& a, const Part& b) { return numberIn(a.name) < numberIn(b.name); });
    QStringList parts;
    for (const Part& part : bar.parts) parts.append(part.name + u' ' + percentText(part.share));
    accessible.append(bar.by + QStringLiteral(": ") + listText(parts));
  }
  changeTo(accessible.join(QStringLiteral("; ")));
}

int GapMap::pictureHeight() const {
  return std::max(1, static_cast<int>(m_bars.size())) * rowHeight();
}

QRect GapMap::barArea(std::size_t row) const {
  int labels = 0;
  for (const Bar& bar : m_bars) labels = std::max(labels, fontMetrics().horizontalAdvance(bar.by));
  const int left = labels + 8;
  return {left, static_cast<int>(row) * rowHeight() + 2, width() - left, rowHeight() - 4};
}

QRect GapMap::partArea(std::size_t row, std::size_t part) const {
  const QRect bar = barArea(row);
  double from = 0;
  for (std::size_t i = 0; i < part; ++i) from += m_bars[row].parts[i].share;
  const int left = static_cast<int>(std::lround(from * bar.width()));
  const int right = static_cast<int>(std::lround((from + m_bars[row].parts[part].share) * bar.width()));
  return {bar.left() + left, bar.top(), right - left, bar.height()};
}

void GapMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const PlotStyle style = screenStyle(palette(), font());
  for (std::size_t row = 0; row < m_bars.size(); ++row) {
    const QRect bar = barArea(row);
    painter.setPen(style.text);
    painter.drawText(QRect(0, bar.top(), bar.left(), bar.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     m_bars[row].by);
    painter.fillRect(bar, style.grid);
    for (std::size_t part = 0; part < m_bars[row].parts.size(); ++part)
      paintPart(painter, partArea(row, part), m_bars[row].parts[part]);
  }
}

/// Paints the part with its name and share, as far as there is room.
void GapMap::paintPart(QPainter& painter, const QRect& area, const Part& part) const {
  if (area.width() < 1) return;
  const PlotStyle style = screenStyle(palette(), font());
  const QColor colour = mixed(style.background, style.upper, 0.12 + 0.88 * part.share);
  painter.fillRect(area.adjusted(0, 0, area.width() > 2 ? -1 : 0, 0), colour);
  const bool isLight = colour.lightnessF() > 0.5;
  painter.setPen(isLight ? Qt::black : Qt::white);
  const QString share = percentText(part.share);
  for (const QString& text : {part.name + QStringLiteral("  ") + share, part.name, share}) {
    if (fontMetrics().horizontalAdvance(text) > area.width() - 4) continue;
    painter.drawText(area, Qt::AlignCenter, text);
    return;
  }
}

QString GapMap::aboutAt(const QPoint& point) const {
  for (std::size_t row = 0; row < m_bars.size(); ++row) {
    const Bar& bar = m_bars[row];
    for (std::size_t part = 0; part < bar.parts.size(); ++part)
      if (partArea(row, part).contains(point))
        return tr("%1 %2: %3 of the gap")
            .arg(bar.by, bar.parts[part].name, percentText(bar.parts[part].share));
  }
  return {};
}

}  // namespace alidade::ui
