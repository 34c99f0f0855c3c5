#pragma once

#include <string_view>

namespace alidade {

// Does a text begin like a file of the field book in the function's name? The rows of `fileFormats` use these
// functions. They look for marks that tables, GSI, M5 and SDR files lack.

/// `CO,Nikon RAW data format V2.00` and further comments (CO), or a station (ST) with sightings that have a
/// time.
bool looksLikeNikonRaw(std::string_view beginning);
/// Records with a mark before each value: `JB,NM…`, `MO,AD…`, `OC,OP…`, `SS,OP…`.
bool looksLikeRw5(std::string_view beginning);
/// `_'STATION_(1.400)_+TARGET_ ?+…m…d`: records not separated into lines.
bool looksLikeGts6(std::string_view beginning);
/// `STN K1,1.400,` and `HV 107.1223,88.4731`: a word, blanks, values separated by commas.
bool looksLikeGts7(std::string_view beginning);
/// `50=JOB`, `5=101`, `7=107.1225`: numbered labels with values.
bool looksLikeGeodimeter(std::string_view beginning);
/// `00NMSC V10-70 …` or `10NM…`: SDR-like records of another program.
bool looksLikeTrimbleDc(std::string_view beginning);
/// `HEADER`, `VERSION 1.20`, `UNITS`.
bool looksLikeIdex(std::string_view beginning);
/// `   0005 INPUT … th       1.500 ih        0.000`: an address, 27 characters, values without units.
bool looksLikeRec500(std::string_view beginning);
/// `For XX|…`: another format of the family of M5, R4 and R5.
bool looksLikeOtherZeiss(std::string_view beginning);
/// `RINEX VERSION / TYPE`, `$GPGGA,…`: files of satellite receivers.
bool looksLikeGnss(std::string_view beginning);

}  // namespace alidade
