// SPDX-License-Identifier: Apache-2.0
// Parts of the study of texture.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "statements.hpp"
#include "study.hpp"

namespace horopter::cli {

/// Thesis 9.2, Fig. 9.1, 9.2: how much texture the correlation needs against the noise. Adds to all of them, and sets
/// the result's conditions and figures.
void texture_against_noise(OutputDirectory& directory, const StudyScope& scope, nlohmann::json& result,
                           std::vector<std::string>& findings, Statements& statements);

}  // namespace horopter::cli
