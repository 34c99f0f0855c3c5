#include "ui/recovery/half_typed_record.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "core/base/phrase.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

const QString typedFormatName = QStringLiteral("alidade-half-typed-1");

constexpr struct {
  const char* key;
  std::string HalfTypedText::*text;
} typedTexts[] = {{"effect", &HalfTypedText::effect}, {"parameter", &HalfTypedText::parameter},
                  {"point", &HalfTypedText::point},   {"round", &HalfTypedText::round},
                  {"face", &HalfTypedText::face},     {"text", &HalfTypedText::text}};

constexpr struct {
  const char* key;
  std::optional<std::size_t> Place::*index;
} typedIndices[] = {{"position", &Place::position}, {"reading", &Place::reading}};

QJsonObject jsonOf(const HalfTypedText& typed) {
  QJsonObject json{{QStringLiteral("field"), qText(typed.place.field)}};
  for (const auto& [key, index] : typedIndices)
    if (const auto value = typed.place.*index) json[QLatin1String(key)] = static_cast<qint64>(*value);
  for (const auto& [key, text] : typedTexts) json[QLatin1String(key)] = qText(typed.*text);
  json[QLatin1String("count")] = static_cast<qint64>(typed.count);
  return json;
}

HalfTypedText typedOf(const QJsonObject& json) {
  HalfTypedText typed;
  typed.place.field = json.value(QLatin1String("field")).toString().toStdString();
  for (const auto& [key, index] : typedIndices) {
    const qint64 value = json.value(QLatin1String(key)).toInteger(-1);
    if (value >= 0) typed.place.*index = static_cast<std::size_t>(value);
  }
  for (const auto& [key, text] : typedTexts)
    typed.*text = json.value(QLatin1String(key)).toString().toStdString();
  typed.count =
      static_cast<std::size_t>(std::max<qint64>(1, json.value(QLatin1String("count")).toInteger(1)));
  return typed;
}

}  // namespace

std::string halfTypedRecordText(const HalfTypedRecord& record) {
  QJsonArray texts;
  for (const HalfTypedText& typed : record.texts) texts.append(jsonOf(typed));
  const QJsonObject json{{QStringLiteral("format"), typedFormatName},
                         {QStringLiteral("of"), record.of},
                         {QStringLiteral("texts"), texts}};
  return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

Result<HalfTypedRecord> readHalfTypedRecord(const std::string& bytes) {
  const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(bytes)).object();
  if (json.value(QLatin1String("format")).toString() != typedFormatName)
    return Problem{Phrase::of("is not a file of unfinished entries")};
  HalfTypedRecord record{.of = json.value(QLatin1String("of")).toString(), .texts = {}};
  for (const QJsonValue& typed : json.value(QLatin1String("texts")).toArray())
    record.texts.push_back(typedOf(typed.toObject()));
  return record;
}

}  // namespace alidade::ui
