"""DynamicSystem, which every analysis works on, and its two implementations."""
