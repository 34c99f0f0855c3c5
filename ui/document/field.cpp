#include "ui/document/field.h"

#include <QtGlobal>
#include <algorithm>
#include <vector>

#include "core/session/session_fields.h"

namespace alidade::ui {

namespace {

Field ofSession(const SessionField& field) {
  return {
      field.key, field.noun,
      [get = field.get](const Session& session, std::size_t) -> const std::string& { return get(session); },
      [at = field.at](Session& session, std::size_t) -> std::string& { return at(session); }, false};
}

/// The protocol is JSON in the session file, unlike the other fields.
constexpr SessionField protocol = {
    .key = "protocol",
    .noun = QT_TRANSLATE_NOOP("Field", "protocol"),
    .get = [](const Session& session) -> const std::string& { return session.protocol; },
    .at = [](Session& session) -> std::string& { return session.protocol; }};

template <auto... members>
Field ofPosition(std::string_view name, const char* noun) {
  return {name, noun,
          [](const Session& session, std::size_t position) -> const std::string& {
            return (session.positions.at(position).*....*members);
          },
          [](Session& session, std::size_t position) -> std::string& {
            return (session.positions.at(position).*....*members);
          }};
}

std::vector<Field> everyField() {
  std::vector<Field> fields;
  for (const SessionField& field : sessionFields()) fields.push_back(ofSession(field));
  fields.push_back(ofSession(protocol));
  for (const Field& field : {
           ofPosition<&Position::axisDeg>("axis_deg", QT_TRANSLATE_NOOP("Field", "axis position")),
           ofPosition<&Position::zero, &PointingZero::horizontal>(
               "pointing_zero.horizontal", QT_TRANSLATE_NOOP("Field", "pointing zero α0")),
           ofPosition<&Position::zero, &PointingZero::vertical>(
               "pointing_zero.vertical", QT_TRANSLATE_NOOP("Field", "pointing zero β0")),
           ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::horizontal>(
               "pointing_zero.face_2.horizontal", QT_TRANSLATE_NOOP("Field", "pointing zero α0 in face 2")),
           ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::vertical>(
               "pointing_zero.face_2.vertical", QT_TRANSLATE_NOOP("Field", "pointing zero β0 in face 2")),
           ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::horizontal>(
               "pointing_zero.after.horizontal",
               QT_TRANSLATE_NOOP("Field", "pointing zero α0 after the readings")),
           ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::vertical>(
               "pointing_zero.after.vertical",
               QT_TRANSLATE_NOOP("Field", "pointing zero β0 after the readings")),
           ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::horizontal>(
               "pointing_zero.after_face_2.horizontal",
               QT_TRANSLATE_NOOP("Field", "pointing zero α0 after the readings in face 2")),
           ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::vertical>(
               "pointing_zero.after_face_2.vertical",
               QT_TRANSLATE_NOOP("Field", "pointing zero β0 after the readings in face 2")),
           ofPosition<&Position::zero, &PointingZero::takenAt>(
               "pointing_zero.taken_at", QT_TRANSLATE_NOOP("Field", "time of the pointing zero")),
           ofPosition<&Position::zero, &PointingZero::returnCode>(
               "pointing_zero.return_code", QT_TRANSLATE_NOOP("Field", "return code of the pointing zero")),
           ofPosition<&Position::zero, &PointingZero::instrumentSerial>(
               "pointing_zero.instrument_serial",
               QT_TRANSLATE_NOOP("Field", "instrument serial number of the pointing zero")),
           ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::takenAt>(
               "pointing_zero.face_2.taken_at",
               QT_TRANSLATE_NOOP("Field", "time of the pointing zero in face 2")),
           ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::returnCode>(
               "pointing_zero.face_2.return_code",
               QT_TRANSLATE_NOOP("Field", "return code of the pointing zero in face 2")),
           ofPosition<&Position::zero, &PointingZero::faceTwo, &ZeroSighting::instrumentSerial>(
               "pointing_zero.face_2.instrument_serial",
               QT_TRANSLATE_NOOP("Field", "instrument serial number of the pointing zero in face 2")),
           ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::takenAt>(
               "pointing_zero.after.taken_at",
               QT_TRANSLATE_NOOP("Field", "time of the pointing zero after the readings")),
           ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::returnCode>(
               "pointing_zero.after.return_code",
               QT_TRANSLATE_NOOP("Field", "return code of the pointing zero after the readings")),
           ofPosition<&Position::zero, &PointingZero::after, &ZeroSighting::instrumentSerial>(
               "pointing_zero.after.instrument_serial",
               QT_TRANSLATE_NOOP("Field",
                                 "instrument serial number of the pointing zero after the readings")),
           ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::takenAt>(
               "pointing_zero.after_face_2.taken_at",
               QT_TRANSLATE_NOOP("Field", "time of the pointing zero after the readings in face 2")),
           ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::returnCode>(
               "pointing_zero.after_face_2.return_code",
               QT_TRANSLATE_NOOP("Field", "return code of the pointing zero after the readings in face 2")),
           ofPosition<&Position::zero, &PointingZero::afterInTwo, &ZeroSighting::instrumentSerial>(
               "pointing_zero.after_face_2.instrument_serial",
               QT_TRANSLATE_NOOP(
                   "Field", "instrument serial number of the pointing zero after the readings in face 2")),
       })
    fields.push_back(field);
  return fields;
}

}  // namespace

std::span<const Field> allFields() {
  static const std::vector<Field> fields = everyField();
  return fields;
}

const Field* fieldNamed(std::string_view name) {
  const auto fields = allFields();
  const auto found = std::ranges::find(fields, name, &Field::name);
  return found == fields.end() ? nullptr : &*found;
}

std::string fieldText(const Session& session, const Place& place) {
  const Field* field = fieldNamed(place.field);
  if (!field || (place.position && *place.position >= session.positions.size())) return {};
  return field->get(session, place.position.value_or(0));
}

}  // namespace alidade::ui
