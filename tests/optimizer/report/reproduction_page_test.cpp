// SPDX-License-Identifier: BSD-3-Clause
// The report of a reproduction: a search that cannot be read is listed with its reason.
#include "optimizer/report/reproduction_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace k3d::optimizer::report {
namespace {

using testing::HasSubstr;

TEST(ReproductionPage, ListsWhatCannotBeRead) {
    Reproduction reproduction;
    SearchReport search;
    search.search = {"kick", "fig2", "Kick by CMA-ES"};
    search.run = 2;
    search.fault = "exp.toml:3: unknown key \"parameters.kick.old\"";
    reproduction.searches.push_back(search);
    EXPECT_THAT(reproduction_text(reproduction), HasSubstr("Kick by CMA-ES, run 2"));
    EXPECT_THAT(reproduction_text(reproduction), HasSubstr("cannot be read: exp.toml:3: unknown key"));
    EXPECT_THAT(searches_csv(reproduction),
                HasSubstr("\n\"kick\",\"2\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"cannot be read: "
                          "exp.toml:3: unknown key \"\"parameters.kick.old\"\"\"\n"));
    EXPECT_THAT(reproduction_html(reproduction), HasSubstr("cannot be read: exp.toml:3"));
}

}  // namespace
}  // namespace k3d::optimizer::report
