// shell_map_shade.glsl -- the light from what a picture shows in a layer.

// A photograph has the shade in its fur already.
vec3 mapRadiance(MapCut cut, Hit hit, Ground g) {
    if (mapPhoto == 0u) return radianceOf(hit, g);
    Coat coat = fur.under;
    if (hit.over) coat = fur.over;
    // White in the light of the studio shows the photograph about as it is.
    coat.ambient = vec3(0.45);
    coat.diffuse = vec3(0.6);
    coat.specular = vec3(0.0);
    coat.rootColor = coat.tipColor = vec3(1.0);
    coat.colorNoise = coat.normalRandomness = 0.0;
    return litHair(hit, coat, g.tint * cut.color, 0.0, 1.0, g);
}
