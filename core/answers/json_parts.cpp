#include "core/answers/json_parts.h"

#include <nlohmann/json.hpp>

#include "core/wording/measure.h"

namespace alidade {

namespace {

using Json = nlohmann::ordered_json;

std::string severityName(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

using FormDocument = nlohmann::ordered_json;

FormDocument kindDocument(const Form& form) {
  return {{"carrier", nameOf(form.carrier)}, {"form", nameOf(form.function)}, {"of", nameOf(form.of)}};
}

FormDocument lookAlikeDocument(const FormLookAlike& other) {
  if (!other.effect.empty()) return {{"effect", other.effect}};
  FormDocument json = kindDocument(other.form);
  if (other.form.turnsWithFace) json["turns_with_face"] = true;
  if (other.form.order > 0) json["order"] = other.form.order;
  return json;
}

FormDocument parametersDocument(const FoundForm& found) {
  FormDocument json = FormDocument::object();
  for (const FormNumber& number : found.parameters) {
    if (number.name == "order")
      json[number.name] = static_cast<int>(number.value);
    else
      json[number.name] = number.value;
    json["standard_uncertainty_" + number.name] = number.sigma;
  }
  return json;
}

}  // namespace

Json findingsJson(const std::vector<Finding>& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"severity", severityName(finding.severity)},
                    {"text", finding.text},
                    {"remedy", finding.remedy},
                    {"where", finding.where.path()}});
  }
  return list;
}

nlohmann::ordered_json attainableJson(const std::vector<AttainableUncertainty>& attainable) {
  auto json = nlohmann::ordered_json::array();
  for (const AttainableUncertainty& one : attainable)
    json.push_back({{"measure", textOf(one.measures)}, {"known", one.known}, {"expanded_mm", one.expanded}});
  return json;
}

nlohmann::ordered_json formDocument(const FoundForm& found) {
  FormDocument json = kindDocument(found.form);
  json["turns_with_face"] = found.form.turnsWithFace;
  json["formula"] = found.formula;
  FormDocument coefficients = FormDocument::object();
  for (const FormNumber& number : found.coefficients) coefficients[number.name] = number.value;
  json["coefficients"] = coefficients;
  json["parameters"] = parametersDocument(found);
  json["probability"] = found.probability;
  json["indistinguishable_from"] = FormDocument::array();
  for (const FormLookAlike& other : found.indistinguishableFrom)
    json["indistinguishable_from"].push_back(lookAlikeDocument(other));
  json["clean_range"] = found.cleanRange;
  json["shrink"] = {{"in_sample", found.shrink.inSample},
                    {"held_out", found.shrink.heldOut},
                    {"f", found.shrink.f},
                    {"p", found.shrink.p},
                    {"held_out_readings", found.shrink.heldOutReadings}};
  return json;
}

nlohmann::ordered_json formsJson(const std::vector<FoundForm>& forms) {
  FormDocument json = FormDocument::array();
  for (const FoundForm& form : forms) json.push_back(formDocument(form));
  return json;
}

}  // namespace alidade
