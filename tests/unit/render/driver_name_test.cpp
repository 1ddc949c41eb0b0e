// Splits the names of drivers, as drivers write them, into their parts.
#include "render/context/driver_name.h"

#include <gtest/gtest.h>

#include "render/context/context.h"

namespace twinlight::driver_name_test {
namespace {

TEST(DriverName, HasParts) {
    struct Row {
        const char *text, *renderer, *name, *version, *provider;
    };
    for (const Row& row : {
             Row{"llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Compatibility Profile) Mesa 22.3.6, OSMesa",
                 "llvmpipe (LLVM 15.0.6, 256 bits)", "llvmpipe", "Mesa 22.3.6", "OSMesa"},
             Row{"softpipe, 3.3 (Compatibility Profile) Mesa 22.3.6, OSMesa", "softpipe", "softpipe", "Mesa 22.3.6",
                 "OSMesa"},
             Row{"softpipe, 2.1 Mesa 25.1.0-devel (git-f1e2d3), EGL", "softpipe", "softpipe", "Mesa 25.1.0-devel",
                 "EGL"},
             Row{"AMD Radeon RX 580 Series (polaris10, LLVM 15.0.6, DRM 3.49, 6.1.0-9-amd64), 4.6 (Compatibility "
                 "Profile) Mesa 22.3.6, EGL",
                 "AMD Radeon RX 580 Series (polaris10, LLVM 15.0.6, DRM 3.49, 6.1.0-9-amd64)",
                 "AMD Radeon RX 580 Series", "Mesa 22.3.6", "EGL"},
             Row{"NVIDIA GeForce GTX 1080/PCIe/SSE2, 4.6.0 NVIDIA 535.54.03, EGL", "NVIDIA GeForce GTX 1080/PCIe/SSE2",
                 "NVIDIA GeForce GTX 1080/PCIe/SSE2", "NVIDIA 535.54.03", "EGL"},
             Row{"a driver, 4.6, EGL", "a driver", "a driver", "", "EGL"},
             Row{"?, ?, OSMesa", "?, ?", "?, ?", "", "OSMesa"},
             Row{"a driver", "a driver", "a driver", "", ""},
             Row{"", "", "", "", ""},
         }) {
        SCOPED_TRACE(row.text);
        const Driver driver = parse_driver_name(row.text);
        EXPECT_EQ(driver.renderer, row.renderer);
        EXPECT_EQ(driver.name, row.name);
        EXPECT_EQ(driver.version, row.version);
        EXPECT_EQ(driver.provider, row.provider);
    }
}

TEST(DriverName, HasAVersionOfARelease) {
    const Driver driver = parse_driver_name("llvmpipe, 4.5 Mesa 22.3.6, OSMesa");
    for (const char* release : {"Mesa 22.3.6", "Mesa 22.3", "Mesa 22"}) EXPECT_TRUE(driver.has_version(release));
    for (const char* release : {"Mesa 22.3.60", "Mesa 22.30", "Mesa 2", "Mesa 25", "NVIDIA 22.3"})
        EXPECT_FALSE(driver.has_version(release)) << release;
}

TEST(DriverName, OfThisContextIsWhole) {
    const auto context = make_offscreen_context(1, 1);
    const Driver driver = current_driver();
    EXPECT_FALSE(driver.name.empty());
    EXPECT_FALSE(driver.version.empty());
    EXPECT_EQ(driver.provider, context_provider());
}

}  // namespace
}  // namespace twinlight::driver_name_test
