#include "ui/report/pdf_archive.h"

#include <QXmlStreamWriter>
#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFObjectHandle.hh>
#include <qpdf/QPDFWriter.hh>

namespace alidade::ui {

namespace {

using Handle = QPDFObjectHandle;

Handle textOf(const QString& text) {
  return Handle::newUnicodeString(text.toStdString());
}

std::string pdfDate(const QDateTime& date) {
  return date.toUTC().toString(QStringLiteral("'D:'yyyyMMddHHmmss'Z'")).toStdString();
}

QString producer() {
  return QStringLiteral("Qt ") + QString::fromLatin1(qVersion()) + QStringLiteral(", qpdf ") +
         QString::fromStdString(QPDF::QPDFVersion());
}

/// Writes one property as an array with one text, as Dublin Core requires.
void writeArray(QXmlStreamWriter& xml, const char* name, const char* kind, const QString& text) {
  if (text.isEmpty()) return;
  xml.writeStartElement(QString::fromLatin1(name));
  xml.writeStartElement(QString::fromLatin1(kind));
  xml.writeStartElement(QStringLiteral("rdf:li"));
  if (qstrcmp(kind, "rdf:Alt") == 0)
    xml.writeAttribute(QStringLiteral("xml:lang"), QStringLiteral("x-default"));
  xml.writeCharacters(text);
  xml.writeEndElement();
  xml.writeEndElement();
  xml.writeEndElement();
}

/// The XMP metadata: contents of the information dictionary, and the PDF/A standard of the file.
std::string metadata(const PdfInformation& information) {
  const QString date = information.date.toUTC().toString(QStringLiteral("yyyy-MM-dd'T'HH:mm:ss'Z'"));
  QString text;
  QXmlStreamWriter xml(&text);
  const auto write = [&xml](const char* name, const QString& value) {
    xml.writeTextElement(QString::fromLatin1(name), value);
  };
  const auto declare = [&xml](const char* prefix, const char* uri) {
    xml.writeAttribute(QStringLiteral("xmlns:") + QString::fromLatin1(prefix), QString::fromLatin1(uri));
  };
  xml.setAutoFormatting(true);
  xml.writeStartElement(QStringLiteral("x:xmpmeta"));
  declare("x", "adobe:ns:meta/");
  xml.writeStartElement(QStringLiteral("rdf:RDF"));
  declare("rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#");
  xml.writeStartElement(QStringLiteral("rdf:Description"));
  xml.writeAttribute(QStringLiteral("rdf:about"), QString());
  declare("dc", "http://purl.org/dc/elements/1.1/");
  declare("xmp", "http://ns.adobe.com/xap/1.0/");
  declare("pdf", "http://ns.adobe.com/pdf/1.3/");
  declare("pdfaid", "http://www.aiim.org/pdfa/ns/id/");
  writeArray(xml, "dc:title", "rdf:Alt", information.title);
  writeArray(xml, "dc:creator", "rdf:Seq", information.author);
  write("xmp:CreatorTool", information.creator);
  write("xmp:CreateDate", date);
  write("xmp:ModifyDate", date);
  write("pdf:Producer", producer());
  write("pdfaid:part", QStringLiteral("3"));
  write("pdfaid:conformance", QStringLiteral("B"));
  xml.writeEndElement();
  xml.writeEndElement();
  xml.writeEndElement();
  return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>" + text.toStdString() +
         "\n<?xpacket end=\"w\"?>";
}

void inform(QPDF& pdf, const PdfInformation& information) {
  Handle stream = Handle::newStream(&pdf, metadata(information));
  stream.getDict().replaceKey("/Type", Handle::newName("/Metadata"));
  stream.getDict().replaceKey("/Subtype", Handle::newName("/XML"));
  pdf.getRoot().replaceKey("/Metadata", pdf.makeIndirectObject(stream));
  Handle facts = Handle::newDictionary();
  facts.replaceKey("/Title", textOf(information.title));
  if (!information.author.isEmpty()) facts.replaceKey("/Author", textOf(information.author));
  facts.replaceKey("/Creator", textOf(information.creator));
  facts.replaceKey("/Producer", textOf(producer()));
  facts.replaceKey("/CreationDate", Handle::newString(pdfDate(information.date)));
  facts.replaceKey("/ModDate", Handle::newString(pdfDate(information.date)));
  pdf.getTrailer().replaceKey("/Info", pdf.makeIndirectObject(facts));
}

/// Copies each font subset's name from its descriptor; removes the list of glyphs that Qt adds for PDF/A-1.
void nameSubsets(QPDF& pdf) {
  for (Handle& object : pdf.getAllObjects()) {
    if (!object.isDictionaryOfType("/Font", "/Type0")) continue;
    Handle descendant = object.getKey("/DescendantFonts").getArrayItem(0);
    Handle descriptor = descendant.getKey("/FontDescriptor");
    descriptor.removeKey("/CIDSet");
    for (Handle* font : {&object, &descendant}) font->replaceKey("/BaseFont", descriptor.getKey("/FontName"));
  }
}

void attach(QPDF& pdf, const std::vector<PdfAttachment>& attachments, const std::string& date) {
  if (attachments.empty()) return;
  QPDFEmbeddedFileDocumentHelper files(pdf);
  Handle associated = Handle::newArray();
  for (const PdfAttachment& attachment : attachments) {
    const std::string name = attachment.fileName.toStdString();
    auto stream = QPDFEFStreamObjectHelper::createEFStream(pdf, attachment.bytes);
    stream.setSubtype(attachment.mimeType).setCreationDate(date).setModDate(date);
    auto file = QPDFFileSpecObjectHelper::createFileSpec(pdf, name, stream);
    file.setDescription(attachment.description.toStdString());
    file.getObjectHandle().replaceKey("/AFRelationship", Handle::newName(attachment.relationship));
    files.replaceEmbeddedFile(name, file);
    associated.appendItem(file.getObjectHandle());
  }
  pdf.getRoot().replaceKey("/AF", associated);
}

}  // namespace

std::string archivedPdf(std::string_view pdf, const PdfInformation& information,
                        const std::vector<PdfAttachment>& attachments) {
  QPDF document;
  document.setSuppressWarnings(true);
  document.setAttemptRecovery(false);
  document.processMemoryFile("report", pdf.data(), pdf.size());
  inform(document, information);
  nameSubsets(document);
  attach(document, attachments, pdfDate(information.date));
  document.getTrailer().removeKey("/ID");  // Qt writes another identifier each time
  QPDFWriter writer(document);
  writer.setOutputMemory();
  writer.forcePDFVersion("1.7");
  writer.setDeterministicID(true);
  writer.setObjectStreamMode(qpdf_o_disable);
  writer.setNewlineBeforeEndstream(true);  // ISO 19005-3, 6.1.7.1
  writer.write();
  const std::shared_ptr<Buffer> written = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(written->getBuffer()), written->getSize()};
}

}  // namespace alidade::ui
