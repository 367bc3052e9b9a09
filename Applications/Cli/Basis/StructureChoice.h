#pragma once

#include "Segmentation.h"

#include <string>
#include <vector>

namespace palpate::cli
{
/// The structures of one segmentation that the words of --label select.
struct StructureChoice
{
  /// A word that matches no structure of this segmentation, or several.
  struct Missing
  {
    Segment Structure;   ///< its number if the word is one, otherwise the word as its name
    std::string Message; ///< why, and what is available
  };

  std::vector<Segment> Found; ///< each structure once, in the order of the words
  std::vector<Missing> Lost;
};

/// No words select every structure. A word is a name, or numbers and names separated by commas.
StructureChoice ChooseStructures(const Segmentation& segmentation,
                                 const std::vector<std::string>& words);
} // namespace palpate::cli
