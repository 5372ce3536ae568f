// What a session's renderers make anew (another method, a second renderer, colours, heights) tells how far it is; stopped
// on its way, all is as it was. On a device.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "brushes/map_file.h"

#include "renderer/vulkan/commands.h"
#include "renderer/vulkan/context.h"
#include "renderer/vulkan/programs.h"
#include "renderer/vulkan/resources.h"
#include "tests/session/on_device.h"

namespace relievo::switching_test {
namespace {

class Switching : public test::OnDevice {
  protected:
    static SessionOptions on_device() { return OnDevice::on_device(64, 48); }

    static auto picture(Renderer& renderer) {
        renderer.restart();
        renderer.render();
        return std::tuple(renderer.read_back(Layer::beauty), renderer.read_back(Layer::depth));
    }

    // `change` is stopped before it begins, on its way, and when all is made.
    static void expect_stopped(Session& session, const std::function<void(const Advance&)>& change) {
        Renderer* const second = second_;
        const auto state = [&] {
            const Displacement& displacement = session.scene().objects[0].displacement;
            return std::tuple(picture(session.renderer()), second ? std::optional(picture(*second)) : std::nullopt,
                              session.scene().method.name, session.scene().method.parameters, session.map().hash(),
                              displacement.procedural ? displacement.procedural->seed : 0, session.procedural(0).get(),
                              session.colours() != nullptr, session.can_undo(), session.steps_made(),
                              test::read_text(journal_));
        };
        const auto before = state();
        for (const double last : {0.0, 0.1, 0.6, 1.0}) {
            EXPECT_THROW(change([&](double part) { return part < last; }), Stopped) << last;
            EXPECT_EQ(state(), before) << last;
        }
    }

    void SetUp() override {
        OnDevice::SetUp();
        second_ = nullptr;
        journal_ = folder_.path() / "session.jsonl";
    }

    SessionOptions journaled() const {
        SessionOptions options = on_device();
        options.journal = journal_;
        return options;
    }

    static inline Renderer* second_ = nullptr;
    static inline std::filesystem::path journal_;
};

TEST_F(Switching, AStoppedChangeOfTheMethodLeavesAllAsItWas) {
    Session session(test::write_scene(folder_.path()), journaled());
    session.set("method", std::string("exact"));
    test::sculpt(session, 2);
    for (const char* name : {"march", "tessellated"})
        expect_stopped(session, [&](const Advance& advance) { session.set("method", std::string(name), advance); });
    test::sculpt(session, 3);  // what is in use follows, and so do the maps that the next method takes over
    session.set("method", std::string("march"));
    session.set("method", std::string("exact"));
    const auto saved = folder_.path() / "saved.tif";
    session.save(saved);
    SessionOptions options = on_device();
    options.map = saved;
    Session fresh(session.scene().path, options);
    EXPECT_EQ(picture(session.renderer()), picture(fresh.renderer()));
}

TEST_F(Switching, IsToldFromBeginningToEndWhileOthersUseTheQueue) {
    Session session(test::write_scene(folder_.path()), on_device());
    vulkan::Commands others(session.context());
    std::vector<double> parts;
    const Advance draw = [&](double part) {
        parts.push_back(part);
        others.run([](VkCommandBuffer cmd) { vulkan::memory_barrier(cmd); });
        return true;
    };
    const std::vector<std::function<void()>> changes{
        [&] { session.set("method", std::string("march"), draw); }, [&] { session.compare_with({"pdm", {}}, draw); },
        [&] { session.compare_with({"march", {}}, draw); }, [&] { session.make_colours(8, draw); }};
    for (const auto& change : changes) {
        parts.clear();
        change();
        EXPECT_TRUE(std::ranges::is_sorted(parts));
        EXPECT_EQ(parts.front(), 0);
        EXPECT_EQ(parts.back(), 1);
    }
    EXPECT_EQ(session.scene().method.name, "march");
}

TEST_F(Switching, AMethodThatIsRefusedIsNotTheScenes) {
    const auto scene = test::write_scene(folder_.path());
    save_map(HeightMap(1024, 1024, 40000), folder_.path() / "map.tif", MapFormat::tiff16, {}, nullptr, {});
    Session session(scene, journaled());
    session.set("method", std::string("tessellated"));
    session.set("method.density", 0.05);
    const auto before = picture(session.renderer());
    EXPECT_THROW(session.set("method.density", 4.0), std::invalid_argument);
    EXPECT_EQ(session.scene().method.parameters.at("density"), 0.05);
    EXPECT_EQ(picture(session.renderer()), before);
}

TEST_F(Switching, AStoppedSecondRendererIsNotThereOrAsItWas) {
    Session session(test::write_scene(folder_.path()), journaled());
    expect_stopped(session, [&](const Advance& advance) { session.compare_with({"pdm", {}}, advance); });
    second_ = &session.compare_with({"pdm", {{"dt", 0.1}}});
    expect_stopped(session, [&](const Advance& advance) { session.compare_with({"march", {}}, advance); });
}

TEST_F(Switching, AStoppedColourMapIsInNeitherPicture) {
    Session session(test::write_scene(folder_.path()), journaled());
    second_ = &session.compare_with({"pdm", {{"dt", 0.1}}});
    expect_stopped(session, [&](const Advance& advance) { session.make_colours(8, advance); });
    session.make_colours(8);
    ASSERT_TRUE(session.colours());
    const auto unpainted = picture(session.renderer());
    session.brush().paint = Paint::colour;
    test::sculpt(session, 3);
    EXPECT_NE(std::get<0>(picture(session.renderer())), std::get<0>(unpainted));
}

TEST_F(Switching, StoppedOtherHeightsAreInNeitherPicture) {
    const auto scene = test::write_scene(folder_.path());
    std::string text = test::read_text(scene);
    const std::string map = R"("map": "map.tif")";
    text.replace(text.find(map), map.size(), R"("procedural": {"exemplar": "map.tif", "scale": 2, "seed": 4})");
    test::write_text(scene, text);
    Session session(scene, journaled());
    second_ = &session.compare_with({"pdm", {{"dt", 0.1}}});
    expect_stopped(session, [&](const Advance& advance) { session.set("procedural.seed", 5.0, advance); });
    expect_stopped(session, [&](const Advance& advance) { session.bake({96, 96}, advance); });
    const auto before = picture(session.renderer());
    session.set("procedural.seed", 5.0);
    EXPECT_NE(picture(session.renderer()), before);
    session.bake({96, 96});
    test::sculpt(session, 3);
    session.undo();
}

// Of lights and materials, only what needs another program takes long: the first light, the last gloss.
TEST_F(Switching, AStoppedSettingIsInNeitherPicture) {
    Session session(test::write_scene(folder_.path()), journaled());
    second_ = &session.compare_with({"exact", {}});  // whose programs are the same
    const auto rendered = picture(session.renderer());  // so that programs are in use
    for (const char* key : {"environment.intensity", "material.specular"}) {
        const bool lit = std::string(key) == "environment.intensity";
        const double now = static_cast<double>(lit ? session.scene().environment.intensity
                                                   : session.scene().objects[0].material.specular);
        const double other = now > 0 ? 0 : 0.5;
        expect_stopped(session, [&](const Advance& advance) { session.set(key, other, advance); });
        std::vector<double> parts;
        session.set(key, other, [&](double part) {
            parts.push_back(part);
            return true;
        });
        EXPECT_FALSE(parts.empty()) << key;
        EXPECT_TRUE(std::ranges::is_sorted(parts)) << key;
        EXPECT_NE(picture(session.renderer()), rendered) << key;
        session.set(key, now);
        EXPECT_EQ(picture(session.renderer()), rendered) << key;
    }
    expect_stopped(session, [&](const Advance& advance) { session.set("amplitude", 0.9, advance); });
    session.set("amplitude", 0.9);
    EXPECT_NE(picture(session.renderer()), rendered);
    int told = 0;
    session.set("material.roughness", 0.5, [&](double) { return ++told > 0; });
    EXPECT_EQ(told, 0) << "nothing was compiled";
}

TEST_F(Switching, APassIsMadeReadyWithoutLosingSamples) {
    Session session(test::write_scene(folder_.path()), on_device());
    Renderer& first = session.renderer();
    Renderer& second = session.compare_with({"exact", {}});
    first.render();
    for (const vulkan::Pass pass : {vulkan::Pass::pick, vulkan::Pass::aov, vulkan::Pass::counts, vulkan::Pass::notes}) {
        EXPECT_EQ(std::ranges::count(first.ready(), pass), 0);
        EXPECT_THROW(session.make_ready(pass, [](double) { return false; }), Stopped);
        EXPECT_EQ(std::ranges::count(first.ready(), pass), 0);
        std::vector<double> parts;
        session.make_ready(pass, [&](double part) {
            parts.push_back(part);
            return true;
        });
        EXPECT_EQ(parts.front(), 0);
        EXPECT_EQ(parts.back(), 1);
        for (Renderer* renderer : {&first, &second}) EXPECT_EQ(std::ranges::count(renderer->ready(), pass), 1);
        const auto compiled = session.context().programs().compiled();
        session.make_ready(pass, [](double) { return false; });
        EXPECT_EQ(session.context().programs().compiled(), compiled);
    }
    EXPECT_EQ(first.samples(), 1);
}

}  // namespace
}  // namespace relievo::switching_test
