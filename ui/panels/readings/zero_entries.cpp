#include "ui/panels/readings/zero_entries.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "ui/document/session_document.h"
#include "ui/models/next_entry.h"
#include "ui/settings/window_font.h"
#include "ui/text/position_text.h"

namespace alidade::ui {

namespace {

enum Column { HorizontalCaption, Horizontal, VerticalCaption, Vertical, AxisCaption, Axis, AxisUnit, Toggle };

}  // namespace

ZeroEntries::ZeroEntries(SessionDocument& document, std::size_t position, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_position(position),
      m_layout(new QGridLayout(this)),
      m_toggle(new QToolButton),
      m_mean(new QLabel) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setColumnStretch(Horizontal, 1);
  m_layout->setColumnStretch(Vertical, 1);
  const QString required = tr("required");
  auto* horizontal = addEntry(
      0, Horizontal, "pointing_zero.horizontal", tr("Pointing zero, horizontal"),
      tr("Horizontal circle reading of the direction perpendicular to the plane of the arc, in face 1 "
         "before the readings of this position"));
  horizontal->setPlaceholderText(required);
  addCaption(0, HorizontalCaption, tr("&α0"), horizontal);
  auto* vertical =
      addEntry(0, Vertical, "pointing_zero.vertical", tr("Pointing zero, vertical"),
               tr("Vertical circle reading of the direction perpendicular to the plane of the arc, in face 1 "
                  "before the readings of this position"));
  vertical->setPlaceholderText(required);
  reportEnteredBy(vertical);
  addCaption(0, VerticalCaption, tr("&β0"), vertical);
  auto* axis = addEntry(0, Axis, "axis_deg", tr("Position of the axis in degrees"),
                        tr("Rotation of the axis: 0 or 180 degrees"), FieldEdit::Shows::AsTyped);
  layOutByFont(*axis, [axis] { axis->setFixedWidth(byFont(56)); });
  passOver(axis);
  addCaption(0, AxisCaption, tr("A&xis"), axis);
  m_layout->addWidget(new QLabel(tr("°")), 0, AxisUnit);

  m_toggle->setObjectName(QStringLiteral("further zeros %1").arg(position));
  m_toggle->setAutoRaise(true);
  m_toggle->setCheckable(true);
  m_toggle->setArrowType(Qt::DownArrow);
  m_toggle->setToolTip(tr("Further sightings of the pointing zero: in face 2, and after the readings"));
  m_toggle->setAccessibleName(tr("Further sightings of the pointing zero"));
  connect(m_toggle, &QToolButton::clicked, this, &ZeroEntries::furtherWanted);
  m_layout->addWidget(m_toggle, 0, Toggle);

  addFurther(1, "face_2", tr("Face 2"), tr("in face 2 before the readings of this position"));
  addFurther(2, "after", tr("After"), tr("in face 1 after the readings of this position"));
  addFurther(3, "after_face_2", tr("After, face 2"), tr("in face 2 after the readings of this position"));
  m_mean->setObjectName(QStringLiteral("mean zero %1").arg(position));
  m_mean->setWordWrap(true);
  m_mean->setTextFormat(Qt::PlainText);
  m_layout->addWidget(m_mean, 4, HorizontalCaption, 1, Toggle + 1);
  m_mean->hide();
  showFurther(false);
}

FieldEdit* ZeroEntries::addEntry(int row, int column, const std::string& field, const QString& accessible,
                                 const QString& hint, FieldEdit::Shows shows) {
  auto* entry = new FieldEdit(m_document, {.position = m_position, .field = field}, shows);
  entry->setObjectName(QStringLiteral("%1 %2").arg(QString::fromStdString(field)).arg(m_position));
  entry->setAccessibleName(accessible);
  entry->setHint(hint);
  m_layout->addWidget(entry, row, column);
  return entry;
}

void ZeroEntries::reportEnteredBy(FieldEdit* vertical) {
  connect(vertical, &QLineEdit::returnPressed, this, [this, vertical] {
    if (!vertical->text().isEmpty()) emit entered();
  });
}

QLabel* ZeroEntries::addCaption(int row, int column, const QString& caption, QWidget* buddy) {
  auto* label = new QLabel(caption);
  label->setBuddy(buddy);
  m_layout->addWidget(label, row, column);
  return label;
}

void ZeroEntries::addFurther(int row, const std::string& key, const QString& caption, const QString& when) {
  const std::string field = "pointing_zero." + key;
  auto* horizontal =
      addEntry(row, Horizontal, field + ".horizontal", tr("Pointing zero, horizontal, %1").arg(when),
               tr("Horizontal circle reading of the pointing zero %1").arg(when));
  auto* vertical = addEntry(row, Vertical, field + ".vertical", tr("Pointing zero, vertical, %1").arg(when),
                            tr("Vertical circle reading of the pointing zero %1").arg(when));
  reportEnteredBy(vertical);
  m_further.insert(m_further.end(),
                   {addCaption(row, HorizontalCaption, caption, horizontal), horizontal, vertical});
}

void ZeroEntries::setEvaluation(const Evaluation& evaluation) {
  m_mean->setText(meanZeroText(evaluation.examined, m_position));
  m_mean->setVisible(!m_mean->text().isEmpty());
}

void ZeroEntries::showFurther(bool shown) {
  for (QWidget* widget : m_further) widget->setVisible(shown);
  m_toggle->setChecked(shown);
  m_toggle->setArrowType(shown ? Qt::UpArrow : Qt::DownArrow);
}

bool ZeroEntries::hasFurther() const {
  const auto& positions = m_document.session().positions;
  return m_position < positions.size() && std::ranges::any_of(furtherZeros, [&](const ZeroSlot& slot) {
           const ZeroSighting& sighting = positions[m_position].zero.*slot.sighting;
           return !sighting.horizontal.empty() || !sighting.vertical.empty();
         });
}

}  // namespace alidade::ui
