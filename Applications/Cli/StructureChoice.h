#pragma once

#include "Segmentation.h"

#include <string>
#include <vector>

namespace palpate::cli
{
/// The structures of one segmentation that the words of --label mean.
struct StructureChoice
{
  /// A word that means no structure of this segmentation, or several.
  struct Missing
  {
    Segment Structure;   ///< its number where the word is one, otherwise the word as its name
    std::string Message; ///< why, and what there is
  };

  std::vector<Segment> Found; ///< each structure once, in the order of the words
  std::vector<Missing> Lost;
};

/// Every structure for no words. A word is a name, or numbers and names between commas.
StructureChoice ChooseStructures(const Segmentation& segmentation,
                                 const std::vector<std::string>& words);
} // namespace palpate::cli
