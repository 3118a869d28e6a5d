#pragma once

#include <string>
#include <vector>

namespace gyromode {

/// A result as it was written.
struct ReportDocument {
  std::string name;  ///< what it is called: the file that it is from
  std::string json;  ///< the document
};

/// Results as one page of HTML that fetches nothing: tables, certificates, charts and moving pictures of any documents
/// that gyromode writes as JSON. Made of the documents alone; their text stays text whatever it holds.
/// @throws Unreadable, with the name, for what is not JSON, not a document of gyromode, of a kind or version that is not
/// known, or without what its kind has
std::string report_page(const std::vector<ReportDocument>& documents);

}  // namespace gyromode
