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

void HeadlineLines::setLines(const std::vector<Headline::Line>& lines) {
  m_lines = lines;
  for (int i = 0; std::cmp_less(i, lines.size()); ++i) {
    const Headline::Line& line = lines[static_cast<std::size_t>(i)];
    const Row& shown = row(i);
    const bool isOfGap = line.kind == Headline::Line::Kind::Gap;
    const QString text = unbroken(qText(line.text));
    shown.icon->setVisible(line.isWarning);
    shown.icon->setPixmap(themeIcon(QStringLiteral("warning")).pixmap(16, 16));
    shown.text->setObjectName(isOfGap ? QStringLiteral("gap hint") : QString());
    shown.text->clear();  // so that `setText` gives a link its present colour
    shown.text->setTextFormat(isOfGap ? Qt::RichText : Qt::PlainText);
    shown.text->setText(
        isOfGap ? QStringLiteral("%1 &nbsp;<a href=\"gap\">%2</a>").arg(text.toHtmlEscaped(), tr("Gap"))
                : text);
    shown.whole->show();
  }
  for (auto i = static_cast<qsizetype>(lines.size()); i < m_rows.size(); ++i) {
    m_rows[i].text->clear();
    m_rows[i].text->setObjectName({});
    m_rows[i].whole->hide();
  }
  setVisible(!lines.empty());
}

void HeadlineLines::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) setLines(std::exchange(m_lines, {}));
}

}  // namespace alidade::ui
