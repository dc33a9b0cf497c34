#include "filters/selftest/changed_definition.h"

#include <stdexcept>

#include "filters/conformance/picture_format.h"
#include "filters/methods/catalogue.h"
#include "filters/reference/shared_images.h"

namespace zproof::selftest {

namespace {

/// The fixture's own scene where the change leaves it as it is, else a copy.
std::shared_ptr<const Scene> scene_under(const DefinitionChange& change, const FilterFixture& fixture) {
    if (!change.of_scene) return {std::shared_ptr<void>{}, &fixture.scene};
    const auto scene = std::make_shared<Scene>(fixture.scene);
    change.of_scene(*scene);
    return scene;
}

}  // namespace

DefinitionChange moved_place(std::string name, const glm::dvec2& texels) {
    return {.name = std::move(name), .of_scene = [texels](Scene& scene) {
                for (Material& material : scene.materials) {
                    Texture& texture = material.base_color;
                    if (texture.image == Texture::none) continue;
                    const Image& image = scene.images[std::size_t(texture.image)];
                    texture.transform.translation += texels / glm::dvec2{image.width, image.height};
                }
            }};
}

FilterClaim claim_under(const DefinitionChange& change, FilterClaim claim) {
    if (change.of_claim) change.of_claim(claim);
    return claim;
}

DefinitionChange biased_lod(std::string name, double levels) {
    return {.name = std::move(name),
            .of_claim = [levels](FilterClaim& claim) { claim.options.lod_bias += levels; }};
}

Picture picture_under(const DefinitionChange& change, const FilterFixture& fixture,
                      const FilterClaim& claim) {
    const FilterClaim now = claim_under(change, claim);
    const texture::Method* const method = texture::find_method(now.method);
    if (method == nullptr) throw std::logic_error("no method '" + now.method + "'");
    return as_stored(
        rasterizer::filtered(*scene_under(change, fixture), fixture.view, fixture.frame,
                             {.method = *method, .options = now.options, .derivatives = now.derivatives}),
        now.precision);
}

ChangedDefinitions::ChangedDefinitions(const FilterFixture& fixture, const FilterClaim& claim)
    : fixture_(fixture),
      claim_(claim),
      surfaces_(
          std::make_shared<const oracle::AdmissibleSurfaces>(fixture.scene, fixture.view, claim.precision)),
      images_(std::make_shared<oracle::filter_reference::SharedImages>()) {}

PixelReference ChangedDefinitions::under(const DefinitionChange& change) const {
    const std::shared_ptr<const Scene> scene = scene_under(change, fixture_);
    const FilterClaim now = claim_under(change, claim_);
    oracle::FilterSettings settings = reference_settings(now.options, now.precision);
    settings.shared = images_;
    if (change.of_reference) change.of_reference(settings);
    View seen = fixture_.view;
    if (change.of_view) change.of_view(seen);
    const auto view = std::make_shared<const View>(std::move(seen));
    const auto reference =
        std::make_shared<const oracle::FilterReference>(*scene, *view, definition_of(now.method), settings,
                                                        change.steps.value_or(step_rule(now.derivatives)));
    return [scene, view, reference, surfaces = surfaces_](int x, int y, const FilterPrecision& precision) {
        return reference->at(x, y, surfaces->at(x, y), precision);
    };
}

}  // namespace zproof::selftest
