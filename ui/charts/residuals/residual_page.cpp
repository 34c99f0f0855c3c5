#include "ui/charts/residuals/residual_page.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>

#include "core/base/number_text.h"
#include "ui/charts/residuals/residual_chart.h"
#include "ui/charts/residuals/residual_plot.h"

namespace alidade::ui {

ResidualPage::ResidualPage(QWidget* parent)
    : QWidget(parent),
      m_chart(new ResidualChart),
      m_kind(new QComboBox),
      m_reach(new QLineEdit),
      m_unit(new QLabel) {
  m_chart->setMinimumSize(240, 130);
  setFocusProxy(m_chart);
  addKinds();
  m_reach->setObjectName(QStringLiteral("residual reach"));
  m_reach->setPlaceholderText(tr("automatic"));
  m_reach->setToolTip(tr("The range of the residuals shown. If it is empty, all residuals are shown"));
  m_reach->setAccessibleName(tr("Range of the residuals, ±"));
  m_reach->setValidator(new QRegularExpressionValidator(
      QRegularExpression(QStringLiteral("\\d{0,6}([.,]\\d{0,4})?")), m_reach));
  m_reach->setFixedWidth(fontMetrics().horizontalAdvance(m_reach->placeholderText() + QStringLiteral("000")));
  auto* range = new QLabel(tr("Sho&w ±"));
  range->setBuddy(m_reach);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(4, 3, 4, 2);
  row->setSpacing(4);
  row->addWidget(m_kind);
  row->addSpacing(6);
  for (QWidget* part :
       {static_cast<QWidget*>(range), static_cast<QWidget*>(m_reach), static_cast<QWidget*>(m_unit)})
    row->addWidget(part);
  row->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(row);
  layout->addWidget(m_chart, 1);
  connect(m_kind, &QComboBox::activated, this, [this] {
    ResidualChoice choice = m_chart->plot()->choice();
    choice.over = static_cast<ResidualChoice::Over>(m_kind->currentData().toInt());
    m_chart->choose(choice);
  });
  connect(m_reach, &QLineEdit::editingFinished, this, &ResidualPage::takeReach);
  connect(m_chart, &ResidualChart::chosen, this, &ResidualPage::showChoice);
  showChoice();
}

void ResidualPage::addKinds() {
  using Over = ResidualChoice::Over;
  const std::pair<Over, QString> kinds[] = {{Over::Slider, tr("Over the slider coordinate s")},
                                            {Over::Order, tr("In the order of reading")},
                                            {Over::Elevation, tr("Over the elevation e")},
                                            {Over::Azimuth, tr("Over the azimuth a")},
                                            {Over::Count, tr("Histogram")},
                                            {Over::Normal, tr("Normal Q–Q plot")}};
  for (const auto& [over, text] : kinds) m_kind->addItem(text, static_cast<int>(over));
  m_kind->setObjectName(QStringLiteral("residual kind"));
  m_kind->setAccessibleName(tr("Kind of the chart"));
  m_kind->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  constexpr int narrowest = 90;  // pixels; the row leaves no more in a narrow window
  m_kind->setMinimumWidth(narrowest);
}

void ResidualPage::takeReach() {
  ResidualChoice choice = m_chart->plot()->choice();
  const auto reach = parseNumber(m_reach->text().toStdString());
  choice.setReach(reach ? *reach : 0);
  if (choice != m_chart->plot()->choice()) m_chart->choose(choice);
  showChoice();
}

void ResidualPage::showChoice() {
  const ResidualChoice& choice = m_chart->plot()->choice();
  m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(choice.over)));
  m_reach->setText(choice.reach() > 0 ? QString::fromStdString(shortestText(choice.reach())) : QString());
  m_unit->setText(choice.showsStandardised() ? QString() : QString(QChar(0x2033)));
}

}  // namespace alidade::ui
