#pragma once

#include "PalpateReportModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
class ReportTable;
class SvgChart;

/// Names and values.
using ReportRows = std::vector<std::pair<std::string, std::string>>;

/// An image or a chart with its caption.
struct PALPATEREPORT_EXPORT ReportFigure
{
  std::string Svg;
  std::string Caption;
  bool IsMarked = false;

  /// The element; empty without an image.
  std::string Html() const;
};

/// A number under its name, with a unit and a remark, which may be empty.
struct ReportCard
{
  std::string Name;
  std::string Value;
  std::string Unit;
  std::string Remark;
};

/// Builds an HTML page that is one file: its style and images are inside, and nothing is loaded. It
/// follows the reader's light or dark scheme, prints on white, and is well-formed XML. All texts
/// are plain and escaped here. A section that gets no content is left out, as are empty texts,
/// lists and figures. Successive figures of one layout, and successive tables of facts, stand side
/// by side.
class PALPATEREPORT_EXPORT ReportPage
{
public:
  /// `kind` stands over the heading: "spherical-harmonic fit".
  ReportPage& Header(const std::string& kind, const std::string& heading,
                     const std::string& about = {});
  /// In a style ("good", "poor" or "bad"), which colours the word.
  ReportPage& Verdict(const std::string& style, const std::string& word, const std::string& text);
  ReportPage& Section(const std::string& heading);
  ReportPage& Subheading(const std::string& heading);
  ReportPage& Text(const std::string& text);
  ReportPage& SoftText(const std::string& text);
  ReportPage& Notes(const std::vector<std::string>& notes);
  ReportPage& Cards(const std::vector<ReportCard>& cards);
  ReportPage& Facts(const std::string& caption, const ReportRows& rows);
  ReportPage& Table(const ReportTable& table);
  /// Texts with the line that they explain, by its style ("mask", "surface", "model", "first", ...;
  /// none if empty).
  ReportPage& Legend(const ReportRows& styles);
  ReportPage& Chart(const SvgChart& chart, const std::string& caption);
  /// In a layout: "slices", "views", "charts" or "thumbnails".
  ReportPage& Figure(const char* layout, const ReportFigure& figure);
  /// HTML in a layout, or by itself if that is empty.
  ReportPage& Put(const std::string& layout, const std::string& html);

  /// The sections, without the page around them.
  std::string Body() const;
  /// The page; its footer has a text, which may be empty, and SoftwareVersions.
  std::string Whole(const std::string& title, const std::string& footer = {}) const;

private:
  std::string Html;
  std::string Heading; // of a section without content so far
  std::string Layout;  // open
  bool IsInSection = false;
};
} // namespace palpate
