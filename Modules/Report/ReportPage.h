#pragma once

#include "PalpateReportModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// A whole HTML page from a title (plain text) and a body (HTML). The style sheet is inline,
/// follows the reader's light or dark scheme, and prints on white; nothing is loaded from other
/// files or the network.
PALPATEREPORT_EXPORT std::string ReportPage(const std::string& title, const std::string& body);
/// What stands before and after the body, of pages that are written bit by bit.
PALPATEREPORT_EXPORT std::string ReportPageStart(const std::string& title);
PALPATEREPORT_EXPORT std::string ReportPageEnd();

/// A section with a heading (plain text); empty if it has no content.
PALPATEREPORT_EXPORT std::string ReportSection(const std::string& heading,
                                               const std::string& content);
PALPATEREPORT_EXPORT std::string ReportSectionStart(const std::string& heading);
PALPATEREPORT_EXPORT std::string ReportSectionEnd();

/// A figure of some content (HTML) with a caption (plain text); empty if it has no content.
PALPATEREPORT_EXPORT std::string ReportFigure(const std::string& content,
                                              const std::string& caption);

/// A card for a definition list of class "cards": a value under its name, with a unit and a remark,
/// which may be empty (plain text).
PALPATEREPORT_EXPORT std::string ReportCard(const std::string& name, const std::string& value,
                                            const std::string& unit, const std::string& remark);

/// A list of notes (plain text); empty if there are none.
PALPATEREPORT_EXPORT std::string ReportNotes(const std::vector<std::string>& notes);

/// A footer with a text (plain, may be empty) and SoftwareVersions.
PALPATEREPORT_EXPORT std::string ReportFooter(const std::string& text = {});
} // namespace palpate
