#include "core/certificate/calibration_certificate.h"

#include <pugixml.hpp>
#include <sstream>
#include <utility>

#include "core/answers/fit_json.h"
#include "core/base/phrase.h"
#include "core/certificate/administrative_data.h"
#include "core/certificate/measurement_results.h"

namespace alidade {

namespace {

constexpr const char* schemaVersion = "3.2.0";

std::string xmlText(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, "  ", pugi::format_indent | pugi::format_no_declaration, pugi::encoding_utf8);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + std::move(text).str();
}

}  // namespace

Result<CalibrationCertificate> calibrationCertificate(const CertificateSource& source,
                                                      const CertificateOptions& options) {
  const Result<StatedEntries> stated = statedEntries(source, options);
  if (!stated) return stated.problem();
  if (!options.isDraft && !stated->notStated.empty())
    return Problem{
        Phrase::of("no certificate is made: ISO/IEC 17025 and the schema require the missing entries: %1",
                   listedNouns(*stated))};
  std::vector<CertificateLanguage> languages = options.languages;
  if (languages.empty()) languages.push_back({"en"});

  pugi::xml_document document;
  const Element certificate = Element(document, languages).add("digitalCalibrationCertificate");
  certificate.attribute("xmlns:dcc", "https://ptb.de/dcc").attribute("xmlns:si", "https://ptb.de/si");
  certificate.attribute("schemaVersion", schemaVersion);
  addAdministrativeData(certificate, source, options, languages, *stated);
  const Say results = [&] { return fitJson(source.answer); };  // always in the binding language
  addMeasurementResults(certificate, source, options.version,
                        languages.front().speak ? languages.front().speak(results) : results());
  if (options.report)
    certificate.file("document", options.report->fileName, options.report->mimeType, options.report->bytes);

  return CalibrationCertificate{xmlText(document), stated->notStated};
}

}  // namespace alidade
