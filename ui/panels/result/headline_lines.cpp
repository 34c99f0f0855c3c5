#include "ui/panels/result/headline_lines.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <utility>

#include "ui/panels/parts/figure_grid.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"

namespace alidade::ui {

HeadlineLines::HeadlineLines(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->setSpacing(3);
}

void HeadlineLines::setHeadline(const Headline& headline) {
  m_isProvisional = headline.isProvisional;
  std::vector<Headline::Line> lines = headline.lines;
  if (!m_isProvisional)
    m_gap = headline.line(Headline::Line::Kind::Gap);
  else if (!m_gap.empty())
    lines.insert(lines.begin(), {.kind = Headline::Line::Kind::Gap,
                                 .text = tr("Before the last change: %1").arg(qText(m_gap)).toStdString()});
  show(lines);
}

void HeadlineLines::clear() {
  m_gap.clear();
  show({});
}

HeadlineLines::Row& HeadlineLines::row(int index) {
  while (index >= m_rows.size()) {
    Row row{.whole = new QWidget, .icon = new QLabel, .text = wrappedLabel()};
    row.text->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(row.text, &QLabel::linkActivated, this, &HeadlineLines::gapActivated);
    auto* line = new QHBoxLayout(row.whole);
    line->setContentsMargins({});
    line->addWidget(row.icon, 0, Qt::AlignTop);
    line->addWidget(row.text, 1);
    layout()->addWidget(row.whole);
    m_rows.append(row);
  }
  return m_rows[index];
}

void HeadlineLines::show(const std::vector<Headline::Line>& lines) {
  m_lines = lines;
  for (int i = 0; std::cmp_less(i, lines.size()); ++i) {
    const Headline::Line& line = lines[static_cast<std::size_t>(i)];
    const Row& shown = row(i);
    const bool isOfGap = line.kind == Headline::Line::Kind::Gap;
    const QString text = unbroken(qText(line.text));
    shown.icon->setVisible(line.isWarning);
    shown.icon->setPixmap(themeIcon(QStringLiteral("warning")).pixmap(16, 16));
    shown.text->setObjectName(isOfGap ? QStringLiteral("gap hint") : QString());
    shown.text->setForegroundRole(isOfGap && m_isProvisional ? QPalette::PlaceholderText
                                                             : QPalette::WindowText);
    shown.text->setTextFormat(isOfGap ? Qt::RichText : Qt::PlainText);
    shown.text->setText(
        isOfGap && !m_isProvisional
            ? QStringLiteral("%1 &nbsp;<a href=\"gap\">%2</a>").arg(text.toHtmlEscaped(), tr("Gap"))
        : isOfGap ? text.toHtmlEscaped()
                  : text);
    shown.whole->show();
  }
  for (auto i = static_cast<qsizetype>(lines.size()); i < m_rows.size(); ++i) {
    m_rows[i].text->clear();
    m_rows[i].whole->hide();
  }
  setVisible(!lines.empty());
}

void HeadlineLines::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
    show(std::exchange(m_lines, {}));  // links keep their colour until set anew
}

}  // namespace alidade::ui
