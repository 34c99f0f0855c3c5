#include "ui/charts/gap/gap_waterfall.h"

#include <QPainter>
#include <algorithm>
#include <limits>

#include "core/exchange/csv_text.h"
#include "ui/charts/plotting/plot_style.h"
#include "ui/charts/plotting/round_numbers.h"
#include "ui/text/cause_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

namespace {

constexpr int space = 8;

}  // namespace

/// The layout: labels at the left, bars on a scale, two columns of figures at the right.
struct GapWaterfall::Layout {
  QRect labels, bars;
  int rms = 0, chiSquare = 0;  ///< right edges of the figures
  double largest = 1;          ///< arcseconds at the right end of the bars
  int top = 0;                 ///< of the first row

  int x(double arcseconds) const {
    return bars.left() + static_cast<int>(arcseconds / largest * (bars.width() - 1));
  }
};

GapWaterfall::GapWaterfall(QWidget* parent)
    : BarRows(tr("The gap before and after each cause"), QStringLiteral("gap"), parent) {}

std::string GapWaterfall::numbers() const {
  CsvText csv{"stage", "rms_arcsec", "reduced_chi2", "intersection_mm", "expanded_mm"};
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const Bar& bar : m_bars) {
    const auto& found = bar.stage.intersection;
    csv.typed(bar.label.toStdString()).number(bar.stage.rms).number(bar.stage.reducedChiSquare);
    csv.number(found ? found->value : none).number(found ? found->expanded : none).endRow();
  }
  csv.typed(tr("what the stated noise leaves").toStdString()).number(m_noise);
  csv.word("").word("").word("").endRow();
  return csv.text();
}

void GapWaterfall::setGap(const Gap& gap) {
  m_bars.clear();
  m_noise = gap.noiseRms;
  double before = gap.stages.empty() ? 0 : gap.stages.front().rms;
  QStringList accessible;
  for (const GapStage& stage : gap.stages) {
    Bar bar{.label = stageText(gap, stage),
            .rms = numberText(stage.rms, stage.rms < 100 ? 2 : 0),
            .chiSquare = numberText(stage.reducedChiSquare, stage.reducedChiSquare < 100 ? 2 : 0),
            .about = {},
            .stage = stage,
            .before = before,
            .after = stage.rms,
            .isModelled = stage.kind != GapStage::Kind::Proposed};
    bar.about = tr("%1: rms %2″, χ²/f %3, Δd = %4 mm")
                    .arg(bar.label, bar.rms, bar.chiSquare, estimateText(stage.intersection));
    accessible.append(bar.about);
    m_bars.push_back(bar);
    before = stage.rms;
  }
  changeTo(accessible.join(QStringLiteral("; ")));
}

int GapWaterfall::pictureHeight() const {
  const int rows = std::max(2, static_cast<int>(m_bars.size()));
  return rows * rowHeight() + 3 * fontMetrics().height() + 12;
}

GapWaterfall::Layout GapWaterfall::layOut() const {
  const QFontMetrics metrics = fontMetrics();
  int labels = 0, rms = metrics.horizontalAdvance(tr("rms ″")), chi = metrics.horizontalAdvance(tr("χ²/f"));
  double largest = m_noise;
  for (const Bar& bar : m_bars) {
    labels = std::max(labels, metrics.horizontalAdvance(bar.label));
    rms = std::max(rms, metrics.horizontalAdvance(bar.rms));
    chi = std::max(chi, metrics.horizontalAdvance(bar.chiSquare));
    largest = std::max({largest, bar.before, bar.after});
  }
  labels = std::min(labels + 6, width() / 2);  // elision needs slightly more than the text
  Layout layout;
  layout.largest = largest > 0 ? largest : 1;
  layout.top = metrics.height() + 4;
  layout.chiSquare = width() - 2;
  layout.rms = layout.chiSquare - chi - space;
  const int height = static_cast<int>(m_bars.size()) * rowHeight();
  layout.labels = QRect(0, layout.top, labels, height);
  layout.bars = QRect(labels + space, layout.top, layout.rms - rms - 2 * space - labels, height);
  return layout;
}

void GapWaterfall::paintEvent(QPaintEvent*) {
  if (m_bars.empty()) return;
  QPainter painter(this);
  const Layout layout = layOut();
  if (layout.bars.width() < 20) return;
  paintScale(painter, layout);
  for (std::size_t row = 0; row < m_bars.size(); ++row) paintBar(painter, layout, row);
  paintNoise(painter, layout);
}

/// Ticks in round arcseconds below the bars.
void GapWaterfall::paintScale(QPainter& painter, const Layout& layout) const {
  const PlotStyle style = screenStyle(palette(), font());
  const int line = fontMetrics().height(), bottom = layout.bars.bottom() + 3;
  const auto right = [&](int edge, int top, const QString& text) {
    painter.drawText(QRect(edge - 120, top, 120, line), Qt::AlignRight | Qt::AlignVCenter, text);
  };
  painter.setPen(style.mutedText);
  right(layout.rms, 0, tr("rms ″"));
  right(layout.chiSquare, 0, tr("χ²/f"));
  const int room = std::max(2, layout.bars.width() / (5 * fontMetrics().horizontalAdvance(u'0')));
  const double step = roundUp125(layout.largest / room);
  for (int i = 0; i * step <= layout.largest * 1.0001; ++i) {
    const int x = layout.x(i * step);
    painter.setPen(style.grid);
    painter.drawLine(x, layout.top, x, bottom);
    painter.setPen(style.mutedText);
    painter.drawText(QRect(x - 40, bottom, 80, line), Qt::AlignHCenter | Qt::AlignTop,
                     numberText(i * step, decimalsOfStep(step)) + (i == 0 ? QChar(0x2033) : QString()));
  }
}

/// The rms expected from the stated noise, as a dashed line over the bars, with its name.
void GapWaterfall::paintNoise(QPainter& painter, const Layout& layout) const {
  const PlotStyle style = screenStyle(palette(), font());
  const int line = fontMetrics().height(), bottom = layout.bars.bottom() + 3, x = layout.x(m_noise);
  painter.setPen(QPen(palette().color(QPalette::Window), 3));
  painter.drawLine(x, layout.top - 2, x, bottom);
  painter.setPen(QPen(style.text, 1, Qt::DashLine));
  painter.drawLine(x, layout.top - 2, x, bottom);
  const int legend = bottom + line + 1;
  painter.drawLine(0, legend + line / 2, 18, legend + line / 2);
  painter.setPen(style.mutedText);
  painter.drawText(QRect(24, legend, width() - 24, line), Qt::AlignVCenter,
                   tr("what the stated noise leaves: %1").arg(arcsecText(m_noise, 2)));
}

void GapWaterfall::paintBar(QPainter& painter, const Layout& layout, std::size_t row) const {
  const PlotStyle style = screenStyle(palette(), font());
  const Bar& bar = m_bars[row];
  const int top = layout.top + static_cast<int>(row) * rowHeight();
  const QRect line(0, top, width(), rowHeight());
  const int from = layout.bars.left(), after = layout.x(bar.after), before = layout.x(bar.before);
  const int thick = rowHeight() - 8;
  painter.setPen(style.text);
  painter.drawText(QRect(0, top, layout.labels.width(), rowHeight()), Qt::AlignLeft | Qt::AlignVCenter,
                   fontMetrics().elidedText(bar.label, Qt::ElideRight, layout.labels.width()));
  if (before > after) {
    const QRect gone(after, top + 4, before - after, thick);
    painter.fillRect(gone, style.band);
    painter.setPen(QPen(style.frame, 1, Qt::DotLine));
    painter.drawLine(gone.topRight(), gone.bottomRight());
  }
  const QRect left(from, top + 4, std::max(2, after - from), thick);
  painter.fillRect(left, bar.isModelled ? style.upper : style.lower);
  painter.setPen(style.text);
  const auto right = [&](int edge, const QString& text) {
    painter.drawText(QRect(edge - 120, line.top(), 120, line.height()), Qt::AlignRight | Qt::AlignVCenter,
                     text);
  };
  right(layout.rms, bar.rms);
  right(layout.chiSquare, bar.chiSquare);
}

QString GapWaterfall::aboutAt(const QPoint& point) const {
  const int down = point.y() - layOut().top, row = down / rowHeight();
  return down >= 0 && row < static_cast<int>(m_bars.size()) ? m_bars[static_cast<std::size_t>(row)].about
                                                            : QString();
}

}  // namespace alidade::ui
