#include "ui/dialogs/protocol_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <algorithm>
#include <utility>

#include "core/session/entry.h"
#include "core/session/face.h"
#include "core/session/row_fields.h"
#include "ui/recovery/form_draft.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

const std::vector<std::vector<int>> faceChoices = {{1}, {2}, {1, 2}, {2, 1}, {1, 2, 2, 1}};
const std::vector<std::vector<int>> axisChoices = {{0, 180}, {0}, {180}, {0, 180, 0}, {0, 180, 0, 180}};
constexpr int changing = 5;  ///< index after `faceChoices`: the face alternates from round to round

QString placeText(const ProtocolPlace& place) {
  return qText(place.slider.empty() ? place.arc : place.slider).remove(u' ');
}

std::string asTyped(const QString& text, CircleUnit unit) {
  const std::string typed =
      completedAngle(text.trimmed().toStdString(), unit == CircleUnit::Dms ? CircleUnit::Degrees : unit);
  return typed;
}

QDoubleSpinBox* minutesBox() {
  auto* box = new QDoubleSpinBox;
  box->setRange(0, 999);
  box->setDecimals(2);
  box->setSingleStep(0.1);
  box->setSuffix(ProtocolDialog::tr(" min"));
  return box;
}

bool isSliderAngle(const std::string& text) {
  return static_cast<bool>(angleEntry(sliderRule, text, VerticalCircle::Zenith));
}

}  // namespace

ProtocolDialog::ProtocolDialog(const SightingProtocol& protocol, CircleUnit unit, QWidget* parent)
    : QDialog(parent),
      m_unit(unit),
      m_description(protocol.description),
      m_name(new QLineEdit),
      m_places(new QLineEdit),
      m_turn(new QLineEdit),
      m_rounds(new QSpinBox),
      m_way(new QComboBox),
      m_faces(new QComboBox),
      m_positions(new QComboBox),
      m_slider(new QCheckBox(tr("The s&lider is read"))),
      m_zeroFaces(new QCheckBox(tr("Pointing zero in &both faces"))),
      m_zerosAfter(new QCheckBox(tr("Pointing zero again &after the readings"))),
      m_byWorth(new QCheckBox(tr("Next: &most informative"))),
      m_turningAxis(minutesBox()),
      m_plungingTelescope(minutesBox()),
      m_drivingSlider(minutesBox()),
      m_remark(new QLabel),
      m_buttons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  setWindowTitle(tr("Edit Protocol"));
  m_way->addItems({tr("one way"), tr("there and back")});
  m_faces->addItems({qText(faceName(1)), qText(faceName(2)), tr("both, 1 then 2"), tr("both, 2 then 1"),
                     tr("both, 1 2 2 1"), tr("changing from round to round")});
  m_positions->addItems(
      {tr("0°, 180°"), tr("0°"), tr("180°"), tr("0°, 180°, 0° again"), tr("0°, 180°, both again")});
  m_rounds->setRange(1, 50);
  m_places->setPlaceholderText(tr("slider coordinates, such as 10 20 30 …"));
  m_turn->setPlaceholderText(tr("not turned"));
  m_remark->setWordWrap(true);
  m_remark->setObjectName(QStringLiteral("protocol remark"));
  auto* form = new QFormLayout(this);
  form->addRow(tr("&Name"), m_name);
  form->addRow(tr("&Places"), m_places);
  form->addRow(tr("&Rounds"), m_rounds);
  form->addRow(tr("&Way"), m_way);
  form->addRow(tr("&Faces"), m_faces);
  form->addRow(tr("Pos&itions"), m_positions);
  form->addRow(tr("Circle &turned between positions by"), m_turn);
  form->addRow(m_slider);
  form->addRow(m_zeroFaces);
  form->addRow(m_zerosAfter);
  form->addRow(m_byWorth);
  form->addRow(tr("Turning the a&xis takes"), m_turningAxis);
  form->addRow(tr("Pl&unging the telescope takes"), m_plungingTelescope);
  form->addRow(tr("&Driving the slider takes"), m_drivingSlider);
  for (QDoubleSpinBox* box : {m_turningAxis, m_plungingTelescope, m_drivingSlider})
    form->setRowVisible(box, false);
  connect(m_byWorth, &QCheckBox::toggled, this, [=, this](bool isByWorth) {
    for (QDoubleSpinBox* box : {m_turningAxis, m_plungingTelescope, m_drivingSlider})
      form->setRowVisible(box, isByWorth);
  });
  form->addRow(m_remark);
  form->addRow(m_buttons);
  connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  show(protocol);
  for (QLineEdit* entry : {m_places, m_turn})
    connect(entry, &QLineEdit::textChanged, this, &ProtocolDialog::check);
  for (QComboBox* choice : {m_way, m_faces, m_positions})
    connect(choice, &QComboBox::currentIndexChanged, this, &ProtocolDialog::check);
  for (QCheckBox* box : {m_zeroFaces, m_zerosAfter, m_byWorth})
    connect(box, &QCheckBox::toggled, this, &ProtocolDialog::check);
  connect(m_rounds, &QSpinBox::valueChanged, this, &ProtocolDialog::check);
  keepDraft();
  check();
}

/// Restores entries that were unfinished when the program was terminated, and tells the user.
void ProtocolDialog::keepDraft() {
  m_draft = new FormDraft(QStringLiteral("protocol"), {}, this);
  m_draft->add(QStringLiteral("name"), *m_name);
  m_draft->add(QStringLiteral("places"), *m_places);
  m_draft->add(QStringLiteral("turn"), *m_turn);
  m_draft->add(QStringLiteral("rounds"), *m_rounds);
  m_draft->add(QStringLiteral("way"), *m_way);
  m_draft->add(QStringLiteral("faces"), *m_faces);
  m_draft->add(QStringLiteral("positions"), *m_positions);
  m_draft->add(QStringLiteral("slider"), *m_slider);
  m_draft->add(QStringLiteral("zero faces"), *m_zeroFaces);
  m_draft->add(QStringLiteral("zeros after"), *m_zerosAfter);
  m_draft->add(QStringLiteral("by worth"), *m_byWorth);
  m_draft->add(QStringLiteral("turning axis"), *m_turningAxis);
  m_draft->add(QStringLiteral("plunging telescope"), *m_plungingTelescope);
  m_draft->add(QStringLiteral("driving slider"), *m_drivingSlider);
  m_draft->finishWith(*this);
}

void ProtocolDialog::show(const SightingProtocol& shown) {
  const SightingProtocol protocol = listedOrder(shown);
  m_name->setText(qText(protocol.name));
  m_minutes = protocol.minutes;
  m_byWorth->setChecked(shown.isByWorth);
  m_turningAxis->setValue(m_minutes.turningAxis);
  m_plungingTelescope->setValue(m_minutes.plungingTelescope);
  m_drivingSlider->setValue(m_minutes.drivingSlider);
  m_slider->setChecked(protocol.readsSlider);
  if (protocol.positions.empty()) return m_way->setCurrentIndex(1);
  const ProtocolPosition& first = protocol.positions.front();
  QStringList places;
  for (const ProtocolPlace& place : protocol.placesOf(first)) places.append(placeText(place));
  m_places->setText(places.join(u' '));
  m_places->setCursorPosition(0);  // shows the first places of a long text
  m_rounds->setValue(static_cast<int>(first.rounds.size()));
  m_way->setCurrentIndex(std::ranges::any_of(first.rounds, &ProtocolRound::isBack) ? 1 : 0);
  const std::vector<int>& faces = first.rounds.front().faces;
  const auto choice = std::ranges::find(faceChoices, faces);
  const bool changes = faces.size() == 1 && first.rounds.size() > 1 && first.rounds[1].faces != faces;
  m_faces->setCurrentIndex(changes ? changing : static_cast<int>(choice - faceChoices.begin()));
  std::vector<int> axes;
  for (const ProtocolPosition& position : protocol.positions) axes.push_back(position.axisDeg);
  const auto order = std::ranges::find(axisChoices, axes);
  m_positions->setCurrentIndex(order == axisChoices.end() ? 0
                                                          : static_cast<int>(order - axisChoices.begin()));
  if (protocol.positions.size() > 1) m_turn->setText(qText(protocol.positions[1].circleTurn));
  m_zeroFaces->setChecked(first.zeros.before.size() > 1);
  m_zerosAfter->setChecked(!first.zeros.after.empty());
}

std::optional<std::vector<ProtocolPlace>> ProtocolDialog::places() const {
  static const QRegularExpression blanks(QStringLiteral("[\\s;]+"));
  std::vector<ProtocolPlace> places;
  for (const QString& text : m_places->text().split(blanks, Qt::SkipEmptyParts)) {
    const std::string slider = asTyped(text, m_unit);
    if (!isSliderAngle(slider)) return std::nullopt;
    places.push_back({.point = static_cast<int>(places.size()) + 1, .slider = slider});
  }
  if (places.empty()) return std::nullopt;
  return places;
}

std::optional<SightingProtocol> ProtocolDialog::protocol() const {
  auto places = this->places();
  const std::string turn =
      m_turn->text().trimmed().isEmpty() ? std::string() : asTyped(m_turn->text(), m_unit);
  if (!places || (!turn.empty() && !isSliderAngle(turn))) return std::nullopt;
  SightingProtocol protocol{.name = m_name->text().trimmed().toStdString(), .description = m_description};
  protocol.readsSlider = m_slider->isChecked();
  protocol.places = *std::move(places);
  const Angle step =
      turn.empty() ? Angle() : angleEntry(sliderRule, turn, VerticalCircle::Zenith)->value_or(Angle());
  for (const int axisDeg : axisChoices[static_cast<std::size_t>(m_positions->currentIndex())]) {
    ProtocolPosition position{.axisDeg = axisDeg, .rounds = {}};
    const auto index = static_cast<double>(protocol.positions.size());
    if (index == 1 && step != Angle())
      position.circleTurn = turn;
    else if (index > 1 && step != Angle())
      position.circleTurn = QString::number(wrapped(step * index).degrees(), 'f', 6).toStdString() + "°";
    if (m_zeroFaces->isChecked()) position.zeros.before = {1, 2};
    if (m_zerosAfter->isChecked()) position.zeros.after = position.zeros.before;
    for (int round = 0; round < m_rounds->value(); ++round) {
      const int choice = m_faces->currentIndex();
      position.rounds.push_back({.isBack = m_way->currentIndex() == 1 && round % 2 == 1,
                                 .faces = choice == changing
                                              ? std::vector<int>{1 + round % 2}
                                              : faceChoices[static_cast<std::size_t>(choice)]});
    }
    protocol.positions.push_back(std::move(position));
  }
  protocol.minutes = m_minutes;
  protocol.minutes.turningAxis = m_turningAxis->value();
  protocol.minutes.plungingTelescope = m_plungingTelescope->value();
  protocol.minutes.drivingSlider = m_drivingSlider->value();
  return m_byWorth->isChecked() ? openOrder(std::move(protocol)) : protocol;
}

void ProtocolDialog::check() {
  const auto own = protocol();
  const std::size_t count = own ? sightingCount(*own) : 0;
  const bool isTooMuch = count > mostSightings;
  m_buttons->button(QDialogButtonBox::Ok)->setEnabled(own && !isTooMuch);
  const QString lead =
      m_draft->isRestored() ? tr("Entries restored as they were when the program ended.") + u' ' : QString();
  m_remark->setText(lead + (!own ? tr("Type the places as angles with blanks between them: 10 20 30.5 40")
                            : isTooMuch ? tr("%1 sightings are too many for a protocol.").arg(count)
                                        : tr("%1 sightings").arg(count)));
}

}  // namespace alidade::ui
