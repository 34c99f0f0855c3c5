#include "ui/report/pdf_attachments.h"

#include <exception>
#include <new>
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <stdexcept>
#include <utility>

#include "core/exchange/words.h"

namespace alidade::ui {

namespace {

using Outcome = AttachedFile::Outcome;

/// Takes what a stream holds, up to a limit.
class Taken : public Pipeline {
 public:
  explicit Taken(std::size_t most) : Pipeline("attached", nullptr), m_most(most) {}

  void write(const unsigned char* data, std::size_t length) override {
    if (m_bytes.size() + length > m_most) m_isTooMuch = true;
    if (m_isTooMuch) throw std::length_error("too much");
    m_bytes.append(reinterpret_cast<const char*>(data), length);
  }
  void finish() override {}

  bool isTooMuch() const { return m_isTooMuch; }
  std::string& bytes() { return m_bytes; }

 private:
  std::size_t m_most;
  std::string m_bytes;
  bool m_isTooMuch = false;
};

AttachedFile contentOf(QPDFObjectHandle stream, std::size_t mostBytes) {
  if (!stream.isStream()) return {Outcome::Missing};
  Taken taken(mostBytes);
  const bool isWhole = stream.pipeStreamData(&taken, nullptr, 0, qpdf_dl_generalized, true);
  if (taken.isTooMuch()) return {Outcome::TooLarge};
  if (!isWhole) return {Outcome::Damaged};
  return {Outcome::Found, std::move(taken.bytes())};
}

bool endsWith(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         lowerCase(std::string(name.substr(name.size() - ending.size()))) == lowerCase(std::string(ending));
}

}  // namespace

AttachedFile attachedFile(std::string_view pdf, std::string_view suffix, std::size_t mostBytes) {
  try {
    QPDF document;
    document.setSuppressWarnings(true);
    document.processMemoryFile("report", pdf.data(), pdf.size());
    QPDFEmbeddedFileDocumentHelper files(document);
    for (const auto& [name, file] : files.getEmbeddedFiles())
      if (endsWith(file->getFilename(), suffix)) return contentOf(file->getEmbeddedFileStream(), mostBytes);
    return {Outcome::NotThere};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    return {Outcome::Unreadable, {}, failure.what()};
  }
}

}  // namespace alidade::ui
